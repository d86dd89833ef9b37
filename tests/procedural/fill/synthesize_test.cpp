#include "procedural/fill/synthesize.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "procedural/batch/texel_batch.h"
#include "procedural/color/srgb.h"
#include "procedural/noise/noise.h"
#include "procedural/numbers/simd_target.h"
#include "tests/procedural/noise/cases.h"
#include "tests/procedural/support/only_target.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

Affine3 scaled(double scale) {
    return {scale * Mat3d(1.0), Vec3d(0.0)};
}

Texture synthesize_marble() {
    Texture texture;
    texture.quadric.i = 0.5;
    NoiseTerm term;
    term.amplitude = 0.5, term.frequency = Vec3d(2.0), term.octaves = 4;
    texture.noise = {term};
    texture.colors.stops = {{0.0, {244, 239, 230}}, {1.0, {59, 58, 64}}};
    return texture;
}

Texture random_texture(std::mt19937& random, bool with_quadric) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto pick = [&](auto... values) {
        const std::array all{values...};
        return all[random() % all.size()];
    };
    Texture texture = synthesize_marble();
    texture.quadric = {};
    if (with_quadric) {
        Quadric& q = texture.quadric;
        for (double* c : {&q.a, &q.b, &q.c, &q.d, &q.e, &q.f, &q.g, &q.h, &q.i, &q.j})
            *c = unit(random);
    }
    texture.noise.resize(1 + random() % 3);
    for (NoiseTerm& term : texture.noise) {
        term.kind = pick(NoiseKind::value, NoiseKind::value, NoiseKind::perlin, NoiseKind::simplex);
        term.radius2 = 0.5;  // continuous: a place's rounding can go across a border of simplices
        term.fade = pick(Fade::linear, Fade::smooth, Fade::quintic);
        if (random() % 2) term.range = pick(NoiseRange::unit, NoiseRange::bipolar);
        term.amplitude = 3.0 * unit(random);
        term.frequency = 4.0 * Vec3d{unit(random), unit(random), unit(random)};
        if (random() % 2) term.phase = 10.0 * Vec3d{unit(random), unit(random), unit(random)};
        if (random() % 3 == 0) {
            term.matrix.emplace();
            for (double& m : *term.matrix) m = 3.0 * unit(random);
        }
        term.seed = std::uint32_t(random());
        term.octaves = 1 + std::uint32_t(random() % 24);
        term.gain = 1.0 + unit(random);
        term.lacunarity = pick(2.0, 1.0, 1.9, 2.17, 0.5);
    }
    return texture;
}

/// The octaves' amplitudes and the size of lattice coordinates, by which errors are bounded.
struct Magnitude {
    double amplitudes = 0.0, coordinates = 0.0;
};

Magnitude magnitude(const Texture& texture, const Vec3d& s) {
    Magnitude result;
    for (const NoiseTerm& term : texture.noise)
        for (std::uint32_t k = 0; k < term.octaves; ++k) {
            result.amplitudes += std::abs(term.amplitude) * std::pow(term.gain, k);
            for (int row = 0; row < 3; ++row) {
                double x = term.frequency[row] * s[row], phase = term.phase[row];
                if (const auto& m = term.matrix) {
                    const auto at = [&](int column) { return (*m)[std::size_t(4 * row + column)]; };
                    x = std::abs(at(0) * s.x) + std::abs(at(1) * s.y) + std::abs(at(2) * s.z);
                    phase = at(3);
                }
                result.coordinates =
                    std::max(result.coordinates,
                             std::abs(x) * std::pow(term.lacunarity, k) + std::abs(phase));
            }
        }
    return result;
}

/// The largest |f - f64| over the contract's bound at that texel.
double worst_share(const SolidAtlas& solid, const Texture& texture, const Affine3& map) {
    const Image<float> field = synthesize_field(solid, texture, map, 2);
    double worst = 0.0;
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                const Vec3d s = map(solid.maps[span.map](std::int64_t(x), std::int64_t(y)));
                const double exact = evaluate_field(texture, s);
                const auto [amplitudes, coordinates] = magnitude(texture, s);
                const double bound = 2.5e-7 * (std::abs(exact) + amplitudes) +
                                     4 * 0x1p-52 * coordinates * amplitudes;
                worst = std::max(worst, std::abs(field(x, y) - exact) / bound);
            }
    return worst;
}

TEST(Synthesis, KeepsTheErrorContractOnRandomRecipes) {
    std::mt19937 random(2);
    for (std::uint32_t i = 0; i < 60; ++i) {
        const double offset = std::array{0.0, 1.0, 1e2, 1e4, 1e6}[i % 5];
        const double step = std::array{1.0 / 256, 1.0 / 16, 1.0 / 2, 2.0}[i / 5 % 4];
        const std::uint32_t block = std::array{3u, 16u, 47u}[i % 3];
        const SolidAtlas solid = SyntheticAtlas{47, block, offset, step, true}.make(i);
        const Texture texture = random_texture(random, i % 2 == 0);
        EXPECT_LT(worst_share(solid, texture, scaled(1.0)), 1.0)
            << "recipe " << i << ", offset " << offset << ", step " << step;
    }
}

TEST(Synthesis, KeepsTheErrorContractAlongLongRows) {
    const SolidAtlas solid = SyntheticAtlas{3000, 3000, 10.0, 0.05, false}.make(1);
    SolidAtlas strip = solid;  // rows of 3000 texels, but only five of them
    strip.row_begin.assign(3001, 5);
    for (std::size_t y = 0; y < 5; ++y) strip.row_begin[y] = y;
    EXPECT_LT(worst_share(strip, synthesize_marble(), scaled(4.0)), 1.0);
}

TEST(Synthesis, AppliesTheTexturesMap) {
    // A rotation with scale and offset in the map is the same as points moved by hand.
    const SolidAtlas solid = SyntheticAtlas{32, 8, 0.0, 0.05, true}.make(5);
    Affine3 map{Mat3d(0, 2, 0, 0, 0, 2, 2, 0, 0), Vec3d(1.0, -7.0, 0.25)};
    EXPECT_LT(worst_share(solid, synthesize_marble(), map), 1.0);
    SolidAtlas moved = solid;
    for (TexelMap& m : moved.maps)
        m = {map(m.origin), map.linear * m.step_x, map.linear * m.step_y, m.anchor_x, m.anchor_y};
    EXPECT_EQ(synthesize_field(solid, synthesize_marble(), map, 1),
              synthesize_field(moved, synthesize_marble(), scaled(1.0), 1));
}

TEST(Synthesis, GivesTheSameBytesForEveryThreadCount) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    std::mt19937 random(3);
    for (const std::uint32_t block : {5u, 300u}) {
        const SolidAtlas solid = SyntheticAtlas{300, block, 100.0, 0.01, true}.make(block);
        Texture texture = random_texture(random, true);
        for (NoiseTerm& term : texture.noise) term.octaves = 1 + term.octaves % 2;
        for (const auto& [name, kernel] : kernel_names) {
            const Image<float> field = synthesize_field(solid, texture, scaled(1.0), 1, kernel);
            const Image<Rgb8> colors =
                synthesize_model<Rgb8>(solid, texture, scaled(1.0), 1, {}, kernel);
            for (const int threads : {2, 7, 0}) {
                EXPECT_EQ(synthesize_field(solid, texture, scaled(1.0), threads, kernel), field);
                EXPECT_EQ(synthesize_model<Rgb8>(solid, texture, scaled(1.0), threads, {}, kernel),
                          colors);
            }
        }
    }
}

TEST(Synthesis, EveryNoiseIsTheReferencesForEveryThreadCount) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    const SolidAtlas solid = SyntheticAtlas{60, 13, 100.0, 0.07, true}.make(4);
    for (const auto& [name, noise] : test::noise_cases(3))
        for (const OctaveShape shape :
             {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged}) {
            Texture texture = synthesize_marble();
            texture.quadric = {};
            NoiseTerm& term = texture.noise[0];
            term.kind = noise.kind, term.fade = noise.fade, term.feature = noise.feature;
            term.radius2 = noise.radius2, term.shape = shape;
            term.amplitude = 1.0, term.octaves = 2, term.period = {0, 6, 300};
            const Image<float> field = synthesize_field(solid, texture, scaled(1.0), 1);
            for (const int threads : {2, 7})
                EXPECT_EQ(synthesize_field(solid, texture, scaled(1.0), threads), field) << name;
            // Octaves weigh 1 and 1/2, noises err by 5e-7, ridges by twice that.
            double worst = 0.0;
            for (std::size_t y = 0; y < solid.size; ++y)
                for (const Span& span : solid.row(y))
                    for (std::size_t x = span.x; x < span.x + span.count; ++x) {
                        const Vec3d s = solid.maps[span.map](std::int64_t(x), std::int64_t(y));
                        worst = std::max(worst, std::abs(field(x, y) - evaluate_field(texture, s)));
                    }
            EXPECT_LT(worst, 2e-6) << name << " " << int(shape);
        }
}

TEST(Synthesis, GivesTheSameBytesOnEveryInstructionSet) {
    std::mt19937 random(8);
    const SolidAtlas solid = SyntheticAtlas{50, 13, 1000.0, 0.07, true}.make(0);
    std::vector<Texture> textures{synthesize_marble()};
    for (int i = 0; i < 12; ++i) textures.push_back(random_texture(random, true));
    for (std::size_t i = 0; i < textures.size(); ++i)
        textures[i].colors.wrap = i % 2 ? Wrap::clamp : Wrap::repeat;
    // A filter for every texture: eight kinds, with and without all octaves.
    const auto filter = [](std::size_t i) { return Filter{FilterKind(i % 8), 3, i % 3 == 0}; };
    std::vector<Image<float>> fields;
    std::vector<Image<Rgb8>> colors, filtered;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        fields.push_back(synthesize_field(solid, textures[i], scaled(1.0), 1));
        colors.push_back(synthesize_model<Rgb8>(solid, textures[i], scaled(1.0), 1));
        filtered.push_back(synthesize_model<Rgb8>(solid, textures[i], scaled(1.0), 1, filter(i)));
    }
    std::string names;
    on_every_target([&] {
        names += simd_level() + " ";
        for (std::size_t i = 0; i < textures.size(); ++i)
            for (const auto& [name, kernel] : kernel_names) {
                if (kernel == Kernel::scanline) continue;  // scanline_kernel_test
                EXPECT_EQ(synthesize_field(solid, textures[i], scaled(1.0), 1, kernel), fields[i])
                    << simd_level() << ", " << name << ", texture " << i;
                EXPECT_EQ(synthesize_model<Rgb8>(solid, textures[i], scaled(1.0), 1, {}, kernel),
                          colors[i])
                    << simd_level() << ", " << name << ", texture " << i;
                EXPECT_EQ(
                    synthesize_model<Rgb8>(solid, textures[i], scaled(1.0), 1, filter(i), kernel),
                    filtered[i])
                    << simd_level() << ", " << name << ", texture " << i;
            }
    });
    RecordProperty("instruction_sets", names);
    EXPECT_FALSE(names.empty());
}

TEST(Synthesis, ColoursAreTheReferenceWithinOneCode) {
    const SolidAtlas solid = SyntheticAtlas{128, 32, 3.0, 0.01, true}.make(6);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        Texture texture = synthesize_marble();
        texture.colors.wrap = wrap;
        texture.colors.stops = {{0.1, {250, 10, 30}}, {0.4, {0, 200, 40}}, {0.9, {3, 5, 255}}};
        const Image<Rgb8> image8 = synthesize_model<Rgb8>(solid, texture, scaled(1.0), 1);
        const Image<Rgb16> image16 = synthesize_model<Rgb16>(solid, texture, scaled(1.0), 1);
        const Image<RgbF> image_f = synthesize_model<RgbF>(solid, texture, scaled(1.0), 1);
        const auto check = [&](std::size_t x, std::size_t y, const Vec3d& linear) {
            const Vec3d coded(srgb_encode(linear.r), srgb_encode(linear.g), srgb_encode(linear.b));
            const Rgb8 c = image8(x, y);
            ASSERT_LE(glm::length(Vec3d(c.r, c.g, c.b) - 255.0 * coded), 1.0);
            const Rgb16 d = image16(x, y);
            ASSERT_LE(glm::length(Vec3d(d.r, d.g, d.b) - 65535.0 * coded), 2.0);
            const RgbF e = image_f(x, y);
            ASSERT_LE(glm::length(Vec3d(e.r, e.g, e.b) - linear), 3e-6);
        };
        for (std::size_t y = 0; y < solid.size; ++y)
            for (const Span& span : solid.row(y))
                for (std::size_t x = span.x; x < span.x + span.count; ++x)
                    check(x, y,
                          evaluate_color(
                              texture.colors,
                              evaluate_field(texture, solid.maps[span.map](std::int64_t(x),
                                                                           std::int64_t(y)))));
    }
}

TEST(Synthesis, TexelsWithoutOwnerHaveTheColourOfFieldZero) {
    SolidAtlas solid;
    solid.size = 4;
    solid.row_begin.assign(5, 0);
    const Rgb8 expected{244, 239, 230};
    const Image<Rgb8> image = synthesize_model<Rgb8>(solid, synthesize_marble(), scaled(1.0), 1);
    ASSERT_EQ(image.pixels().size(), 16u);
    for (const Rgb8 c : image.pixels()) EXPECT_EQ(c, expected);
}

TEST(Synthesis, SurvivesHopelessCoordinates) {
    for (const double huge : {1e18, 1e300}) {
        const SolidAtlas solid = SyntheticAtlas{20, 7, huge, huge, true}.make(2);
        Texture texture = synthesize_marble();
        texture.quadric = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
        const Image<Rgb8> image = synthesize_model<Rgb8>(solid, texture, scaled(1e6), 1);
        EXPECT_EQ(image.width(), 20u);
        texture.quadric = {};
        const Image<float> field = synthesize_field(solid, texture, scaled(1e6), 1);
        for (const float f : field.pixels()) EXPECT_TRUE(f >= 0.0f && f <= 1.0f) << f;
    }
}

}  // namespace
}  // namespace burl
