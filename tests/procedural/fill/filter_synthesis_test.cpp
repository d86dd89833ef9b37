// Filtered textures against means over every texel that are counted in float64.
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "procedural/color/map_pieces.h"
#include "procedural/color/table.h"
#include "procedural/field/break_kernel.h"
#include "procedural/fill/synthesize.h"
#include "procedural/model/band_limit.h"
#include "procedural/model/octaves.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

constexpr FilterKind map_filters[] = {FilterKind::table_mip,  FilterKind::table_sat,
                                      FilterKind::table_sat3, FilterKind::exact,
                                      FilterKind::trapezoid,  FilterKind::trapezoid2};

Filter filter_of(FilterKind kind) {
    Filter filter;
    filter.kind = kind;
    return filter;
}

ColorMap zebra() {  // jumps at 0 and 1/2
    return {Wrap::repeat,
            {{0.0, {0, 0, 0}}, {0.5, {0, 0, 0}}, {0.5, {255, 255, 255}}, {1.0, {255, 255, 255}}}};
}

ColorMap hills() {
    return {Wrap::repeat, {{0.0, {10, 40, 200}}, {0.4, {250, 180, 20}}, {0.7, {90, 255, 90}}}};
}

NoiseTerm noise(NoiseKind kind, double frequency, std::uint32_t octaves) {
    NoiseTerm term;
    term.kind = kind, term.frequency = Vec3d(frequency), term.octaves = octaves;
    return term;
}

Texture marble(const ColorMap& map) {
    Texture texture;
    texture.quadric.i = 2.0;
    texture.noise = {noise(NoiseKind::value, 3.0, 2), noise(NoiseKind::perlin, 2.0, 1)};
    texture.colors = map;
    return texture;
}

SolidAtlas footprints(double step) {
    SyntheticAtlas atlas;
    atlas.size = 24, atlas.block = 8, atlas.step = step, atlas.holes = false;
    return atlas.make(5);
}

/// Mean colour of every texel, n x n samples.
Image<RgbF> counted(const SolidAtlas& solid, const Texture& texture, int n) {
    const std::vector<Octave> octaves = expand_octaves(texture);
    const PreparedColorMap map(texture.colors);
    Image<RgbF> image(solid.size, solid.size);
    for (std::uint32_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                const TexelMap& texel = solid.maps[span.map];
                Vec3d sum(0.0);
                for (int i = 0; i < n * n; ++i) {
                    const Vec3d p = texel(x, y) + ((i % n + 0.5) / n - 0.5) * texel.step_x +
                                    ((i / n + 0.5) / n - 0.5) * texel.step_y;
                    sum += map(evaluate_field(texture.quadric, octaves, p));
                }
                sum /= double(n * n);
                image(x, y) = {float(sum.x), float(sum.y), float(sum.z)};
            }
    return image;
}

double rmse(const Image<RgbF>& a, const Image<RgbF>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &p = a.pixels()[i], &q = b.pixels()[i];
        sum += std::pow(p.r - q.r, 2) + std::pow(p.g - q.g, 2) + std::pow(p.b - q.b, 2);
    }
    return std::sqrt(sum / (3.0 * double(a.pixels().size())));
}

Image<RgbF> filtered(const SolidAtlas& solid, const Texture& texture, const Filter& filter) {
    return synthesize_model<RgbF>(solid, texture, {}, 1, filter);
}

TEST(FilterSynthesis, LinearFieldsAreExact) {
    Texture texture;
    texture.quadric.d = 3.0, texture.quadric.g = -1.0, texture.quadric.i = 0.5;
    const SolidAtlas solid = footprints(0.1);
    for (const ColorMap& map : {zebra(), hills()}) {
        texture.colors = map;
        const Image<RgbF> truth = counted(solid, texture, 128);
        for (const FilterKind kind : {FilterKind::trapezoid, FilterKind::trapezoid2})
            EXPECT_LT(rmse(filtered(solid, texture, filter_of(kind)), truth), 2e-3);
        EXPECT_GT(rmse(filtered(solid, texture, {}), truth), 0.02) << "without a filter it shows";
    }
}

TEST(FilterSynthesis, EveryFilterComesCloserThanNone) {
    for (const ColorMap& map : {zebra(), hills()}) {
        const Texture texture = marble(map);
        const SolidAtlas solid = footprints(0.02);
        const Image<RgbF> truth = counted(solid, texture, 24);
        const double none = rmse(filtered(solid, texture, {}), truth);
        for (const FilterKind kind : map_filters) {
            // Its entries are too wide by up to half, which blurs a smooth map more than it helps.
            if (kind == FilterKind::table_mip && map == hills()) continue;
            EXPECT_LT(rmse(filtered(solid, texture, filter_of(kind)), truth), 0.8 * none)
                << int(kind);
        }
        EXPECT_LT(rmse(filtered(solid, texture, filter_of(FilterKind::trapezoid)), truth),
                  0.25 * none);
    }
}

TEST(FilterSynthesis, CurvatureHelpsWhereTheFieldBends) {
    Texture texture;
    texture.quadric.a = texture.quadric.e = texture.quadric.h = 40.0;
    texture.colors = hills();
    const SolidAtlas solid = footprints(0.01);  // f changes by half a period per texel
    const Image<RgbF> truth = counted(solid, texture, 64);
    EXPECT_LT(rmse(filtered(solid, texture, filter_of(FilterKind::trapezoid2)), truth),
              0.5 * rmse(filtered(solid, texture, filter_of(FilterKind::trapezoid)), truth));
}

TEST(FilterSynthesis, SamplesConverge) {
    const Texture texture = marble(hills());
    const SolidAtlas solid = footprints(0.04);
    const Image<RgbF> truth = counted(solid, texture, 24);
    Filter few{FilterKind::supersample, 4, false}, many{FilterKind::supersample, 64, false};
    const double rough = rmse(filtered(solid, texture, few), truth);
    EXPECT_LT(rmse(filtered(solid, texture, many), truth), 0.5 * rough);
    EXPECT_LT(rough, rmse(filtered(solid, texture, {}), truth));
}

TEST(FilterSynthesis, ConstantStaysConstant) {
    Texture texture = marble({Wrap::repeat, {{0.1, {90, 120, 200}}, {0.8, {90, 120, 200}}}});
    const SolidAtlas solid = footprints(0.5);
    const Image<Rgb8> plain = synthesize_model<Rgb8>(solid, texture, {}, 1);
    for (int kind = 0; kind < 8; ++kind)
        for (const bool band_limit : {false, true}) {
            const Filter filter{FilterKind(kind), 5, band_limit};
            EXPECT_EQ(synthesize_model<Rgb8>(solid, texture, {}, 1, filter), plain) << kind;
        }
}

TEST(FilterSynthesis, PointsAreTheColourItself) {
    const Texture texture = marble(hills());
    const SolidAtlas solid = footprints(0.0);
    const Image<RgbF> plain = filtered(solid, texture, {});
    for (const FilterKind kind : {FilterKind::exact, FilterKind::trapezoid, FilterKind::trapezoid2})
        EXPECT_LT(rmse(filtered(solid, texture, filter_of(kind)), plain), 1e-7);
}

TEST(FilterSynthesis, SameBytesForEveryThreadCount) {
    SyntheticAtlas atlas;
    atlas.size = 100, atlas.block = 23, atlas.step = 0.1;
    const SolidAtlas solid = atlas.make(3);
    Texture texture = marble(zebra());
    texture.noise.push_back(noise(NoiseKind::simplex, 2.0, 3));
    for (int kind = 0; kind < 8; ++kind) {
        const Filter filter{FilterKind(kind), 6, true};
        const Image<Rgb16> one = synthesize_model<Rgb16>(solid, texture, {}, 1, filter);
        for (const int threads : {2, 5})
            EXPECT_EQ(synthesize_model<Rgb16>(solid, texture, {}, threads, filter), one) << kind;
    }
}

TEST(BreakDistance, IsThatToTheNearestBreakAndNoMore) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        ColorMap map = zebra();
        map.wrap = wrap;
        map.stops.insert(map.stops.begin() + 1, {0.21, {9, 9, 9}});
        const MapPieces pieces(map);
        const BreakDistance distance(pieces);
        for (int i = 0; i < 2000; ++i) {
            const double f = 3.0 * uniform(random) - 1.0, half = std::exp2(-8.0 * uniform(random));
            double nearest = 2.0;
            for (const MapBreak& b : pieces.breaks())
                for (double period = -3.0; period <= 3.0; ++period)
                    if (wrap == Wrap::repeat || period == 0.0)
                        nearest = std::min(nearest, std::abs(f - b.position - period));
            const auto entry = std::uint32_t(map_index(wrap, f) * BreakDistance::entry_count);
            if (half >= nearest) {
                EXPECT_FALSE(distance.straight(entry, half)) << f;
            }
            // Beyond the ends of a clamped map the entry at the end speaks for all.
            if (f < 0.0 || f > 1.0) continue;
            const double slack = 2.0 / BreakDistance::entry_count;
            if (half + slack < std::min(nearest, 1.0)) {
                EXPECT_TRUE(distance.straight(entry, half)) << f;
            }
        }
    }
}

TEST(BreakKernel, FindsTexelsThatMayReachABreak) {
    const BreakDistance distance{MapPieces(hills())};
    std::mt19937 random(10);
    std::uniform_real_distribution<float> slope(-0.3f, 0.3f);
    alignas(64) std::int32_t entries[batch_capacity + batch_padding] = {};
    std::uint32_t found[batch_capacity + 2 * batch_padding];
    const auto slopes = std::make_unique<SlopeBatch>();
    for (const std::size_t count : {std::size_t(1), std::size_t(37), batch_capacity}) {
        for (std::size_t j = 0; j < batch_capacity; ++j) {
            entries[j] = std::int32_t(random() % (BreakDistance::entry_count + 1));
            slopes->u[j] = slope(random), slopes->v[j] = j % 3 ? slope(random) : 0.0f;
        }
        slopes->u[count / 2] = std::numeric_limits<float>::quiet_NaN();
        slopes->v[count / 3] = std::numeric_limits<float>::infinity();
        std::vector<std::uint32_t> expected;
        for (std::uint32_t j = 0; j < count; ++j) {
            const float half = 0.5f * (std::abs(slopes->u[j]) + std::abs(slopes->v[j]));
            if (!distance.straight(std::uint32_t(entries[j]), double(half))) expected.push_back(j);
        }
        const std::size_t bent = find_bent(distance.data(), entries, *slopes, count, found);
        EXPECT_EQ(std::vector(found, found + bent), expected) << count;
    }
}

TEST(BandLimit, FollowsTheOctavesLeft) {
    EXPECT_EQ(band_weight({0.2, 0, 0}, {0, 0.01, 0}), 1.0);
    EXPECT_EQ(band_weight({0.0, 0, 0}, {0, 0, 0}), 1.0);
    EXPECT_EQ(band_weight({0.1, 0, 0}, {0, 0.5, 0}), 0.0);
    EXPECT_NEAR(band_weight({std::exp2(-1.5), 0, 0}, {0, 0, 0}), 0.5, 1e-12);
    EXPECT_EQ(band_weight(std::numeric_limits<double>::quiet_NaN()), 0.0);
    // Continuous and falling, also where the logarithm is left out.
    for (double square = 0.08, before = 1.0; square < 0.2; square += 1e-5) {
        const double weight = band_weight(square);
        EXPECT_LE(weight, before);
        EXPECT_NEAR(weight, before, 1e-3);
        before = weight;
    }
}

TEST(BandLimit, LeavesTheMeanOfWhatATexelCannotShow) {
    for (const OctaveShape shape :
         {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged}) {
        Texture texture;
        texture.noise = {noise(NoiseKind::perlin, 100.0, 1)};
        texture.noise[0].shape = shape;
        texture.colors = {Wrap::clamp, {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}}};
        const SolidAtlas solid = footprints(0.5);
        const Filter filter{FilterKind::none, 1, true};
        const Image<RgbF> left = filtered(solid, texture, filter),
                          all = filtered(solid, texture, {});
        double mean = 0.0, mean_left = 0.0;
        for (std::size_t i = 0; i < all.pixels().size(); ++i) {
            if (shape == OctaveShape::plain) continue;
            mean += double(all.pixels()[i].r) / double(all.pixels().size());
            mean_left += double(left.pixels()[i].r) / double(all.pixels().size());
        }
        EXPECT_EQ(left.pixels()[0], left.pixels()[300]) << "nothing is left but a constant";
        EXPECT_NEAR(mean, mean_left, 0.03);  // 576 texels: a standard error of about .008
    }
}

}  // namespace
}  // namespace burl
