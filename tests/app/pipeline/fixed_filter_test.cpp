// Filters of pictures in fixed point: with many bits they are those of float64, whose slopes are
// gradients.
#include <gtest/gtest.h>

#include <random>

#include "app/pipeline/texture_color.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

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

}  // namespace
}  // namespace burl
