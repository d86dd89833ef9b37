// Filters in fixed point: with many bits they are those of float64, whose slopes are gradients, and
// bakes have those of pictures.
#include <gtest/gtest.h>

#include <random>

#include "app/pipeline/fill_texture.h"
#include "app/pipeline/material.h"
#include "app/pipeline/texture_color.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "tests/procedural/support/synthetic_atlas.h"

namespace burl {
namespace {

/// Root mean square difference of the colours of marble by `kind` in two precisions, over
/// footprints of this size.
double difference(const Precision& precision, FilterKind kind, FilterKind exact_kind, double size) {
    Recipe recipe = load_recipe("marble");
    const FilteredColor exact = filtered_color(recipe, exact_kind);
    recipe.precision = precision;
    const FilteredColor fixed = filtered_color(recipe, kind);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    double sum = 0.0;
    constexpr int points = 2000;
    for (int i = 0; i < points; ++i) {
        const Vec3d s(place(random), place(random), place(random));
        const Footprint footprint{Vec3d(size, 0.0, 0.3 * size), Vec3d(0.0, size, -0.2 * size)};
        const Vec3d d = Vec3d(fixed(s, footprint)) - Vec3d(exact(s, footprint));
        sum += glm::dot(d, d) / 3.0;
    }
    return std::sqrt(sum / points);
}

TEST(FixedFilter, IsThatOfFloat64WithManyBits) {
    const Precision fine{PrecisionKind::fixed, {8, 16}}, coarse{PrecisionKind::fixed, {8, 6}};
    for (const FilterKind kind :
         {FilterKind::table_mip, FilterKind::table_sat, FilterKind::exact, FilterKind::trapezoid}) {
        const double same = difference(fine, kind, kind, 1.0 / 64.0);
        EXPECT_LT(same, 0.004) << to_string(kind);
        EXPECT_GT(difference(coarse, kind, kind, 1.0 / 64.0), 5.0 * same) << to_string(kind);
        EXPECT_GT(difference(fine, kind, FilterKind::none, 0.125), 0.01) << to_string(kind);
    }
}

TEST(FixedFilter, RefusesGraphs) {
    Recipe recipe = load_recipe("checks");
    recipe.precision = {PrecisionKind::fixed, {8, 8}};
    EXPECT_THROW(filtered_color(recipe, FilterKind::trapezoid), Error);
}

/// Marble in a precision on an atlas whose texels take steps of up to 1/16.
Image<RgbF> baked(const SolidAtlas& solid, const Precision& precision, FilterKind kind,
                  int threads = 1) {
    Recipe recipe = load_recipe("marble");
    recipe.precision = precision, recipe.filter.kind = kind;
    return fill_texture<RgbF>(solid, recipe, {threads, Kernel::automatic, false});
}

TEST(FixedFilter, OfABakeIsThatOfThePicture) {
    const SolidAtlas solid = SyntheticAtlas{60, 13, 3.0, 1.0 / 16.0, true}.make(5);
    for (const Precision& precision :
         {Precision{PrecisionKind::fixed, {8, 8}}, Precision{PrecisionKind::fixed, {6, 4}}})
        for (const FilterKind kind :
             {FilterKind::table_mip, FilterKind::table_sat, FilterKind::table_sat3,
              FilterKind::exact, FilterKind::trapezoid}) {
            Recipe recipe = load_recipe("marble");
            recipe.precision = precision;
            const Affine3 map = texture_from_solid(recipe);
            const FilteredColor color = filtered_color(recipe, kind);
            const Image<RgbF> image = baked(solid, precision, kind);
            for (std::size_t y = 0; y < solid.size; ++y)
                for (const Span& span : solid.row(y))
                    for (std::uint32_t x = span.x; x < span.x + span.count; ++x) {
                        const TexelMap& texel = solid.maps[span.map];
                        const Vec4d c =
                            color(map(texel(x, std::int64_t(y))),
                                  {map.linear * texel.step_x, map.linear * texel.step_y});
                        ASSERT_EQ(image(x, y), (RgbF{float(c.x), float(c.y), float(c.z)}))
                            << to_string(kind) << ' ' << x << ' ' << y;
                    }
            EXPECT_EQ(baked(solid, precision, kind, 3), image) << to_string(kind);
            EXPECT_NE(baked(solid, precision, FilterKind::none), image) << to_string(kind);
        }
}

/// Root mean square difference of two images.
double difference(const Image<RgbF>& a, const Image<RgbF>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const RgbF &c = a.pixels()[i], &d = b.pixels()[i];
        sum += (std::pow(c.r - d.r, 2) + std::pow(c.g - d.g, 2) + std::pow(c.b - d.b, 2)) / 3.0;
    }
    return std::sqrt(sum / double(a.pixels().size()));
}

/// The filters that look f up several times take the same values in both arithmetics; the others
/// have differences to one side for slopes.
TEST(FixedFilter, OfABakeIsThatOfFloat64WithManyBits) {
    const SolidAtlas solid = SyntheticAtlas{60, 13, 0.0, 1.0 / 400.0, true}.make(6);
    const Precision exact{PrecisionKind::float64, {}}, fine{PrecisionKind::fixed, {8, 16}},
        coarse{PrecisionKind::fixed, {8, 6}};
    for (const auto& [kind, most] : {std::pair(FilterKind::trapezoid2, 1e-3),
                                     {FilterKind::supersample, 1e-3},
                                     {FilterKind::trapezoid, 4e-3},
                                     {FilterKind::table_sat, 4e-3}}) {
        const double same = difference(baked(solid, fine, kind), baked(solid, exact, kind));
        EXPECT_LT(same, most) << to_string(kind);
        EXPECT_GT(difference(baked(solid, coarse, kind), baked(solid, exact, kind)), 5.0 * same)
            << to_string(kind);
    }
    const SolidAtlas far = SyntheticAtlas{60, 13, 0.0, 0.125, true}.make(6);
    EXPECT_GT(
        difference(baked(far, fine, FilterKind::trapezoid2), baked(far, exact, FilterKind::none)),
        0.01);
}

}  // namespace
}  // namespace burl
