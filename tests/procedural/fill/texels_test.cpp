// Textures filled texel by texel: in_float64 against the scalar reference and the fast path, fixed
// point against the field of one point.
#include "procedural/fill/texels.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "procedural/color/srgb.h"
#include "procedural/color/table.h"
#include "procedural/fill/synthesize.h"
#include "procedural/fixed/field.h"
#include "procedural/model/octaves.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

const Precision in_float64{PrecisionKind::float64, {}};
const Affine3 texels_twice{2.0 * Mat3d(1.0), Vec3d(0.25, 0.0, -1.0)};

Precision fixed(unsigned integer_bits, unsigned fraction_bits) {
    return {PrecisionKind::fixed, {integer_bits, fraction_bits}};
}

Texture texels_marble() {
    Texture texture;
    texture.quadric.i = 0.5, texture.quadric.a = 0.3;
    NoiseTerm term;
    term.amplitude = 0.5, term.frequency = Vec3d(2.0), term.octaves = 4;
    texture.noise = {term};
    texture.colors.stops = {{0.0, {244, 239, 230}}, {0.7, {200, 10, 30}}, {1.0, {59, 58, 64}}};
    return texture;
}

/// visit(x, y, point in texture coordinates) for every texel with an owner.
template <class Visit>
void for_each_texel(const SolidAtlas& solid, const Visit& visit) {
    for (std::size_t y = 0; y < solid.size; ++y)
        for (const Span& span : solid.row(y))
            for (std::size_t x = span.x; x < span.x + span.count; ++x)
                visit(x, y, texels_twice(solid.maps[span.map](std::int64_t(x), std::int64_t(y))));
}

TEST(SynthesizeTexels, InFloat64IsTheReferenceItself) {
    const SolidAtlas solid = SyntheticAtlas{60, 13, 3.0, 0.03, true}.make(1);
    const Texture texture = texels_marble();
    const Image<double> field = field_of_texels(solid, texture, texels_twice, in_float64, 1);
    const Image<RgbF> colors =
        synthesize_texels<RgbF>(solid, texture, texels_twice, in_float64, {}, 1);
    const Image<Rgb8> codes =
        synthesize_texels<Rgb8>(solid, texture, texels_twice, in_float64, {}, 1);
    const SrgbEncoder<std::uint8_t> encode;
    for_each_texel(solid, [&](std::size_t x, std::size_t y, const Vec3d& s) {
        const double f = evaluate_field(texture, s);
        ASSERT_EQ(field(x, y), f);
        const Vec3d color = PreparedColorMap(texture.colors)(f);
        ASSERT_EQ(colors(x, y), (RgbF{float(color.x), float(color.y), float(color.z)}));
        ASSERT_EQ(codes(x, y), (Rgb8{encode(color.x), encode(color.y), encode(color.z)}));
        ASSERT_LE(glm::length(color - evaluate_color(texture.colors, f)), 1e-15);
    });
    EXPECT_EQ(codes(59, 59), synthesize_model<Rgb8>(solid, texture, texels_twice, 1)(59, 59));
}

TEST(SynthesizeTexels, InFixedPointIsTheFieldOfEveryPoint) {
    const SolidAtlas solid = SyntheticAtlas{40, 9, 3.0, 0.03, true}.make(2);
    const Texture texture = texels_marble();
    const FixedField one(texture, {5, 7});
    const Image<double> field = field_of_texels(solid, texture, texels_twice, fixed(5, 7), 1);
    const Image<RgbF> colors =
        synthesize_texels<RgbF>(solid, texture, texels_twice, fixed(5, 7), {}, 1);
    for_each_texel(solid, [&](std::size_t x, std::size_t y, const Vec3d& s) {
        ASSERT_EQ(field(x, y), one(s));
        const Vec3d color = evaluate_color(texture.colors, one(s));
        ASSERT_NEAR(colors(x, y).r, color.x, 1e-7);
        ASSERT_NEAR(colors(x, y).b, color.z, 1e-7);
    });
}

/// The largest difference of two images, linear light.
double difference(const Image<RgbF>& a, const Image<RgbF>& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &c = a.pixels()[i], &d = b.pixels()[i];
        for (const float e : {c.r - d.r, c.g - d.g, c.b - d.b})
            worst = std::max(worst, std::abs(double(e)));
    }
    return worst;
}

/// The fast path has the same definition of every filter, and float32's error.
TEST(SynthesizeTexels, FiltersAsTheFastPathDoes) {
    const SolidAtlas solid = SyntheticAtlas{48, 11, 0.0, 0.08, true}.make(3);
    Texture texture = texels_marble();
    texture.quadric = {.i = 0.05};
    NoiseTerm ridges = texture.noise[0];
    ridges.kind = NoiseKind::simplex, ridges.shape = OctaveShape::ridged, ridges.amplitude = 0.2;
    texture.noise.push_back(ridges);
    texture.colors.wrap = Wrap::clamp;
    using enum FilterKind;
    for (const FilterKind kind :
         {none, table_mip, table_sat, table_sat3, exact, trapezoid, trapezoid2, supersample})
        for (const bool band_limit : {false, true}) {
            const Filter filter{kind, 9, band_limit};
            const Image<RgbF> fast =
                synthesize_model<RgbF>(solid, texture, texels_twice, 1, filter);
            const Image<RgbF> exactly =
                synthesize_texels<RgbF>(solid, texture, texels_twice, in_float64, filter, 1);
            EXPECT_LT(difference(fast, exactly), 2e-5) << int(kind) << band_limit;
            EXPECT_NE(fast, exactly) << int(kind) << band_limit;
            const bool plain = kind == none && !band_limit;
            const Image<RgbF> point =
                synthesize_texels<RgbF>(solid, texture, texels_twice, in_float64, {}, 1);
            EXPECT_EQ(difference(exactly, point) > 1e-3, !plain);
        }
}

TEST(SynthesizeTexels, GivesTheSameBytesForEveryThreadCount) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 8);
    const SolidAtlas solid = SyntheticAtlas{120, 17, 3.0, 0.02, true}.make(4);
    const Texture texture = texels_marble();
    const auto filled = [&](const Precision& precision, const Filter& filter, int threads) {
        return synthesize_texels<Rgb8>(solid, texture, texels_twice, precision, filter, threads);
    };
    const Filter faded{FilterKind::trapezoid2, 1, true}, sampled{FilterKind::supersample, 4, false},
        sloped{FilterKind::trapezoid, 1, false}, table{FilterKind::table_mip, 1, false};
    for (const auto& [precision, filter] : {std::pair(in_float64, Filter{}),
                                            {in_float64, faded},
                                            {fixed(8, 8), Filter{}},
                                            {fixed(8, 8), sampled},
                                            {fixed(8, 8), sloped},
                                            {fixed(8, 8), table}})
        for (const int threads : {2, 7, 0})
            EXPECT_EQ(filled(precision, filter, threads), filled(precision, filter, 1));
}

TEST(SynthesizeTexels, LeavesTexelsWithoutOwnerTheColourOfFieldZero) {
    SolidAtlas solid;
    solid.size = 4;
    solid.row_begin.assign(5, 0);
    const Rgb8 expected{244, 239, 230};
    for (const Precision& precision : {in_float64, fixed(8, 8)})
        for (const FilterKind kind : {FilterKind::none, FilterKind::supersample,
                                      FilterKind::trapezoid, FilterKind::table_sat}) {
            const Image<Rgb8> image = synthesize_texels<Rgb8>(solid, texels_marble(), texels_twice,
                                                              precision, {kind, 4, false}, 1);
            for (const Rgb8 c : image.pixels()) EXPECT_EQ(c, expected);
        }
}

}  // namespace
}  // namespace burl
