// Early exits: that no colour shows them, that they happen where they can, and that they are left
// alone where they cannot.
#include "procedural/field/early_exit.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "procedural/color/point_colors.h"
#include "procedural/field/exit_estimate.h"
#include "procedural/field/exit_kernel.h"
#include "procedural/fill/pieces.h"
#include "procedural/fill/synthesize.h"
#include "procedural/noise/bounds.h"
#include "tests/procedural/noise/cases.h"
#include "tests/procedural/support/only_target.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Affine3 identity{Mat3d(1.0), Vec3d(0.0)};
constexpr Rgb8 red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255};

std::vector<std::pair<double, double>> intervals_of(Wrap wrap, std::vector<ColorStop> stops) {
    std::vector<std::pair<double, double>> found;
    for (const auto& [begin, end] : constant_intervals({wrap, std::move(stops)}))
        found.emplace_back(begin, end);
    return found;
}

TEST(ConstantIntervals, AreTheMapsEndsAndWhereStopsAgree) {
    using Intervals = std::vector<std::pair<double, double>>;
    EXPECT_EQ(intervals_of(Wrap::clamp, {{0.25, red}, {0.75, blue}}),
              (Intervals{{-infinity, 0.25}, {0.75, infinity}}));
    EXPECT_EQ(intervals_of(Wrap::clamp, {{0.2, red}, {0.3, green}, {0.5, green}, {1.0, blue}}),
              (Intervals{{-infinity, 0.2}, {0.3, 0.5}, {1.0, infinity}}));
    EXPECT_EQ(intervals_of(Wrap::repeat, {{0.2, red}, {0.3, green}, {0.5, green}}),
              (Intervals{{0.3, 0.5}}));
    EXPECT_EQ(intervals_of(Wrap::repeat, {{0.0, red}, {1.0, blue}}), Intervals{});
    EXPECT_EQ(intervals_of(Wrap::repeat, {{0.5, red}}), (Intervals{{-infinity, infinity}}));
    // A jump lies between two constants; the same colour on both sides makes one of them.
    EXPECT_EQ(intervals_of(Wrap::clamp, {{0.5, red}, {0.5, blue}}),
              (Intervals{{-infinity, 0.5}, {0.5, infinity}}));
    EXPECT_EQ(intervals_of(Wrap::clamp, {{0.1, red}, {0.5, red}, {0.5, blue}, {0.8, blue}}),
              (Intervals{{-infinity, 0.5}, {0.5, infinity}}));
}

TEST(NoiseBounds, HoldEveryNoise) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-50.0, 50.0);
    for (const auto& [name, noise] : test::noise_cases(3))
        for (const OctaveShape shape :
             {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged}) {
            const NoiseBounds bounds = shaped(shape, noise_bounds(noise));
            double low = infinity, high = -infinity;
            for (int i = 0; i < 4000; ++i) {
                const double n = shaped(
                    shape,
                    evaluate_noise(noise, Vec3d{place(random), place(random), place(random)}));
                low = std::min(low, n), high = std::max(high, n);
            }
            EXPECT_GE(low, bounds.low) << name;
            EXPECT_LE(high, bounds.high) << name;
            EXPECT_GT(high - low, 0.2 * (bounds.high - bounds.low)) << name;
        }
}

TEST(FindUndecided, IsTheDefinition) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> value(-3.0, 3.0);
    const std::vector<IndexInterval> intervals = {{-infinity, -0.7}, {0.25, 0.375}, {0.6, 0.8}};
    alignas(64) double f[200 + batch_padding] = {};
    for (double& x : f) x = double(float(value(random)));
    f[3] = std::numeric_limits<double>::quiet_NaN(), f[4] = infinity, f[5] = -infinity;
    f[6] = 0.25, f[7] = 0.375, f[8] = 4e6 + 0.3;
    for (const bool repeats : {false, true})
        for (const std::size_t count : {1u, 5u, 31u, 200u}) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t j = 0; j < count; ++j) {
                const auto x = float(repeats ? f[j] - std::floor(f[j]) : f[j]);
                bool inside = false;
                for (const auto& [begin, end] : intervals)
                    inside = inside || (x >= float(begin) && x < float(end));
                if (!inside || (repeats && !(std::abs(f[j]) < largest_repeated)))
                    expected.push_back(j);
            }
            on_every_target([&] {
                std::vector<std::uint32_t> found(count + 2 * batch_padding);
                found.resize(find_undecided(repeats, intervals, f, count, found.data()));
                EXPECT_EQ(found, expected);
            });
        }
}

TEST(CheapestExits, AreTakenWhereTheySaveMore) {
    using Points = std::vector<std::size_t>;
    const std::vector<double> two(2, 1.0), four(4, 1.0), eight(8, 1.0);
    EXPECT_EQ(cheapest_exits({0.0, 0.0, 0.01, 0.02}, four), Points{});
    EXPECT_EQ(cheapest_exits({0.0, 0.9, 0.9, 0.9}, four), Points{1});
    EXPECT_EQ(cheapest_exits({1.0, 1.0}, two), Points{0});
    EXPECT_EQ(cheapest_exits({0.0, 0.45, 0.45, 0.9, 0.9, 0.9, 0.9, 0.9}, eight), (Points{1, 3}));
    // A dear octave is worth an exit that a cheap one is not.
    EXPECT_EQ(cheapest_exits({0.0, 0.4}, {1.0, plain_octave_cost}), Points{1});
    EXPECT_EQ(cheapest_exits({0.0, 0.4}, two), Points{});
    EXPECT_EQ(cheapest_exits({0.0, 0.9, 0.9, 0.9}, std::vector<double>(4, shared_octave_cost)),
              Points{});
}

TEST(LikelyShares, AreThoseOfNormalNumbers) {
    const std::vector<OctaveRange> ranges = {{-0.5, 0.5, 1.0}, {0.0, 0.5, 1.0}};
    const std::vector<IndexInterval> ends = {{-infinity, 0.1}, {0.9, infinity}};
    const std::vector<ExitPoint> points = exit_points(ends, ranges);
    const std::vector<double> shares = likely_shares(points, ranges, 0.5);
    ASSERT_EQ(shares.size(), 2u);
    EXPECT_EQ(shares[0], 0.0);
    // Half a unit may come below, none above: beyond -0.4 and 0.9 is 0.9 / 0.29 and 0.4 / 0.29.
    EXPECT_NEAR(
        shares[1],
        0.5 * (std::erfc(0.9 / 0.29 / std::sqrt(2.0)) + std::erfc(0.4 / 0.29 / std::sqrt(2.0))),
        1e-3);
    EXPECT_EQ(likely_shares(exit_points(ends, ranges), ranges, 7.0)[0], 1.0);
}

Texture random_texture(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Texture texture;
    Quadric& q = texture.quadric;
    if (random() % 2)
        for (double* c : {&q.a, &q.b, &q.c, &q.d, &q.e, &q.f, &q.g, &q.h, &q.i, &q.j})
            *c = unit(random) - 0.5;
    texture.noise.resize(1 + random() % 3);
    constexpr std::array kinds{NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex,
                               NoiseKind::worley, NoiseKind::cell};
    for (NoiseTerm& term : texture.noise) {
        const std::size_t choice = random() % 2 ? 2 : kinds.size();
        term.kind = kinds[random() % choice];
        term.fade = Fade(random() % 3);
        term.amplitude = unit(random);
        term.frequency = 3.0 * Vec3d{unit(random), unit(random), unit(random)};
        term.seed = std::uint32_t(random());
        term.octaves = 1 + std::uint32_t(random() % 6);
        term.gain = random() % 2 ? 0.5 : 0.7;
    }
    texture.colors.wrap = Wrap(random() % 2);
    std::vector<double> positions(2 + random() % 4);
    for (double& position : positions) position = unit(random);
    std::ranges::sort(positions);
    for (const double position : positions)
        texture.colors.stops.push_back({position, std::array{red, green, blue}[random() % 3]});
    return texture;
}

Economy without_exits() {
    Economy economy;
    economy.skips.forbid(Skip::early_exit);
    economy.skips.forbid(Skip::constant_tiles);
    return economy;
}

template <class Pixel>
bool same_bytes(const Image<Pixel>& a, const Image<Pixel>& b) {
    return a.pixels().size() == b.pixels().size() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

TEST(EarlyExit, NoByteShowsIt) {
    std::mt19937 random(3);
    std::size_t exits = 0, tiles = 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
        const SolidAtlas solid =
            SyntheticAtlas{64, std::array{5u, 16u, 64u}[i % 3], 0.0, 0.02, true}.make(i);
        const Texture texture = random_texture(random);
        SynthesisWork all, work;
        Economy whole = without_exits();
        whole.work = &all;
        const Economy early{{}, &work, {}};
        EXPECT_TRUE(
            same_bytes(synthesize_rgbf(solid, texture, identity, 1, {}, Kernel::automatic, early),
                       synthesize_rgbf(solid, texture, identity, 1, {}, Kernel::automatic, whole)))
            << i;
        const std::uint64_t exited = work.octaves_skipped[unsigned(Skip::early_exit)];
        const std::uint64_t constant = work.octaves_skipped[unsigned(Skip::constant_tiles)];
        EXPECT_EQ(work.octaves + exited + constant, all.octaves);
        exits += exited > 0, tiles += constant > 0;
        EXPECT_EQ(synthesize_rgb8(solid, texture, identity, 1),
                  synthesize_rgb8(solid, texture, identity, 1, {}, Kernel::automatic, whole));
        EXPECT_EQ(synthesize_rgb16(solid, texture, identity, 1),
                  synthesize_rgb16(solid, texture, identity, 1, {}, Kernel::automatic, whole));
    }
    EXPECT_GT(exits + tiles, 2u);
}

/// Looks wherever it can, whether that pays or not.
TEST(EarlyExit, NoColourShowsItHoweverOftenItLooks) {
    std::mt19937 random(4);
    std::size_t decided = 0;
    for (std::uint32_t i = 0; i < 60; ++i) {
        const SolidAtlas solid = SyntheticAtlas{32, 1 + 7 * (i % 5), 0.0, 0.03, true}.make(i);
        const Texture texture = random_texture(random);
        const Kernel kernel = Kernel(i % kernel_names.size());
        FieldSampler sampler(texture, false, kernel);
        const auto exact = std::make_unique<FieldBatch>(), early = std::make_unique<FieldBatch>();
        const auto buffers = std::make_unique<ExitBuffers>();
        for (FieldBatch* batch : {exact.get(), early.get()})
            for (std::size_t y = 0; y < 32; ++y) add_row(solid, solid.maps, y, *batch, [] {});
        sampler.plan_exit(texture.colors, *early, {0.0, -1.0});
        sampler.values(*exact);
        sampler.values_for_colors(*early, *buffers);
        const PointColors<RgbF> color(texture.colors);
        for (std::size_t j = 0; j < exact->count; ++j)
            ASSERT_EQ(color(early->field[j]), color(exact->field[j])) << i << " " << j;
        decided += early->streams.work.octaves_skipped[unsigned(Skip::early_exit)] > 0;
    }
    EXPECT_GT(decided, 4u);
}

TEST(EarlyExit, CountsDependOnNothingElse) {
    std::mt19937 random(5);
    const SolidAtlas solid = SyntheticAtlas{300, 60, 0.0, 0.005, true}.make(7);
    Texture texture;
    texture.quadric.i = 0.5;
    NoiseTerm smooth, distances;
    smooth.amplitude = 0.5, smooth.octaves = 6;
    distances.kind = NoiseKind::worley, distances.amplitude = 0.02, distances.octaves = 3;
    texture.noise = {smooth, distances};
    texture.colors = {Wrap::clamp, {{0.4, red}, {0.45, blue}}};
    SynthesisWork one;
    const Image<Rgb8> image =
        synthesize_rgb8(solid, texture, identity, 1, {}, Kernel::automatic, {{}, &one, {}});
    EXPECT_GT(one.octaves_skipped[unsigned(Skip::early_exit)], 0u);
    on_every_target([&] {
        for (const int threads : {1, 2, 5}) {
            SynthesisWork work;
            EXPECT_EQ(synthesize_rgb8(solid, texture, identity, threads, {}, Kernel::automatic,
                                      {{}, &work, {}}),
                      image);
            EXPECT_EQ(work, one);
        }
    });
}

/// Without quadrics nobody has to look at a texel to know that mostly nothing is to be had.
TEST(EarlyExit, IsRuledOutHardlyEverWhereAPilotFindsIt) {
    std::mt19937 random(6);
    int possible = 0, found = 0, missed = 0;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.03, true}.make(i);
        Texture texture = random_texture(random);
        texture.quadric = {};
        texture.colors.wrap = Wrap::clamp;
        FieldSampler sampler(texture, false);
        const auto pilot = std::make_unique<FieldBatch>();
        const auto buffers = std::make_unique<ExitBuffers>();
        add_pilot(solid, solid.maps, *pilot);
        sampler.plan_exit(texture.colors, *pilot);
        sampler.values_for_colors(*pilot, *buffers);
        const SynthesisWork& work = pilot->streams.work;
        const bool exits = work.octaves_skipped[unsigned(Skip::early_exit)] > 0 ||
                           work.octaves_skipped[unsigned(Skip::constant_tiles)] > 0;
        missed += exits && !may_exit(texture, {});
        possible += may_exit(texture, {});
        found += exits;
    }
    EXPECT_GT(found, 10);
    EXPECT_LT(possible, 250);
    EXPECT_LE(20 * missed, found) << "fields that hardly change over the atlas";
}

TEST(EarlyExit, IsRuledOutForClouds) {
    Texture clouds;
    clouds.noise.resize(1);
    clouds.noise[0].amplitude = 0.5, clouds.noise[0].octaves = 4;
    clouds.colors = {Wrap::clamp, {{0.25, blue}, {0.45, green}, {0.72, red}}};
    EXPECT_FALSE(may_exit(clouds, {}));
    clouds.quadric.j = 5.0;
    EXPECT_TRUE(may_exit(clouds, {})) << "all beyond the map";
    EXPECT_FALSE(may_exit(clouds, without_exits().skips));
    clouds.quadric.j = 0.0, clouds.quadric.i = 3.0;
    EXPECT_TRUE(may_exit(clouds, {})) << "a slope may leave the map";
}

TEST(EarlyExit, LeavesMapsAloneThatAreNowhereConstant) {
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.02, true}.make(1);
    Texture texture;
    texture.noise.resize(1);
    texture.noise[0].octaves = 4;
    texture.colors = {Wrap::repeat, {{0.0, red}, {0.5, blue}, {1.0, red}}};
    SynthesisWork work;
    synthesize_rgb8(solid, texture, identity, 1, {}, Kernel::automatic, {{}, &work, {}});
    EXPECT_EQ(work.octaves, 4 * work.texels);
}

TEST(EarlyExit, EvaluatesNothingOfOneColour) {
    const SolidAtlas solid = SyntheticAtlas{64, 16, 0.0, 0.02, true}.make(1);
    Texture texture;
    texture.noise.resize(1);
    texture.noise[0].octaves = 4;
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        texture.colors = {wrap, {{0.3, green}, {0.5, green}}};
        SynthesisWork work;
        const Image<Rgb8> image =
            synthesize_rgb8(solid, texture, identity, 1, {}, Kernel::automatic, {{}, &work, {}});
        EXPECT_EQ(work.octaves, 0u);
        for (const Rgb8 color : image.pixels()) EXPECT_EQ(color, green);
    }
}

}  // namespace
}  // namespace burl
