// Colour maps with transparent stops: colours multiplied by alpha, and alpha, against closed forms
// and against sums over a definition of their own.
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "procedural/color/filtered_colors.h"
#include "procedural/color/srgb.h"
#include "procedural/color/table.h"

namespace burl {
namespace {

constexpr std::array map_filters{FilterKind::exact, FilterKind::trapezoid, FilterKind::table_mip,
                                 FilterKind::table_sat, FilterKind::table_sat3};

/// Red, green and blue times alpha, and alpha.
Vec4d multiplied(const ColorStop& stop) {
    const double alpha = double(stop.alpha) / 255.0;
    return {alpha * srgb_decode(stop.color.r / 255.0), alpha * srgb_decode(stop.color.g / 255.0),
            alpha * srgb_decode(stop.color.b / 255.0), alpha};
}

/// The definition, for stops at 0 and 1 and others between them.
Vec4d defined(const ColorMap& map, double f) {
    const double t = map.wrap == Wrap::repeat ? f - std::floor(f) : std::min(std::max(f, 0.0), 1.0);
    for (std::size_t i = map.stops.size() - 1; i > 0; --i) {
        const ColorStop &low = map.stops[i - 1], &high = map.stops[i];
        if (t < low.position || low.position == high.position) continue;
        const double share = (t - low.position) / (high.position - low.position);
        return (1.0 - share) * multiplied(low) + share * multiplied(high);
    }
    return multiplied(map.stops.front());
}

Vec4d filtered(const ColorMap& map, FilterKind kind, double f, double u, double v) {
    return {FilteredColors(map, kind)(f, u, v), FilteredColors(alpha_map(map), kind)(f, u, v).x};
}

double largest_of(const Vec4d& difference) {
    const Vec4d a = glm::abs(difference);
    return std::max({a.x, a.y, a.z, a.w});
}

ColorMap veil(Wrap wrap) {
    return {wrap,
            {{0.0, {255, 255, 255}, 0},
             {0.25, {200, 40, 20}, 64},
             {0.5, {0, 255, 0}, 0},
             {0.5, {10, 20, 250}, 255},
             {1.0, {90, 90, 10}, 128}}};
}

TEST(TransparentMap, InterpolatesColoursTimesAlphaAndAlpha) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const ColorMap map = veil(wrap);
        const PreparedColorMap color(map), alpha(alpha_map(map));
        for (double f = -1.3; f < 2.3; f += 0.0137) {
            const Vec4d expected = defined(map, f);
            EXPECT_LT(largest_of(Vec4d(color(f), alpha(f).x) - expected), 1e-14) << f;
            const Vec4d reference(evaluate_color(map, f), evaluate_color(alpha_map(map), f).x);
            EXPECT_LT(largest_of(reference - expected), 1e-14) << f;
        }
    }
}

TEST(TransparentMap, ATransparentStopHasNoColourThatShows) {
    ColorMap white{Wrap::clamp, {{0.0, {255, 255, 255}, 0}, {1.0, {200, 0, 0}, 255}}},
        green = white;
    green.stops[0].color = {0, 255, 0};
    for (double f = 0.0; f <= 1.0; f += 0.125) {
        EXPECT_EQ(evaluate_color(white, f), evaluate_color(green, f));
        // The colour divided by alpha is the opaque stop's, all the way.
        if (f == 0.0) continue;
        EXPECT_NEAR(evaluate_color(white, f).x / evaluate_color(alpha_map(white), f).x,
                    srgb_decode(200 / 255.0), 1e-15);
        EXPECT_EQ(evaluate_color(white, f).y, 0.0);
    }
}

TEST(TransparentMap, MeansOfTwoStopsAreClosedForms) {
    const ColorStop low{0.0, {255, 128, 0}, 51}, high{1.0, {10, 60, 200}, 204};
    const Vec4d p = multiplied(low), q = multiplied(high);
    for (const FilterKind kind : map_filters) {
        const ColorMap repeat{Wrap::repeat, {low, high}}, clamp{Wrap::clamp, {low, high}};
        // A whole period: the mean of the ends. A part without an end: the middle's colour.
        EXPECT_LT(largest_of(filtered(repeat, kind, 0.3, 1.0, 0.0) - 0.5 * (p + q)), 2e-7);
        EXPECT_LT(largest_of(filtered(clamp, kind, 0.5, 0.25, 0.0) - 0.5 * (p + q)), 2e-7);
        // Tables of MIP levels take what lies beyond an end for the end.
        if (kind == FilterKind::table_mip) continue;
        // From -1/2 to 1/2: half of it the low end, half from there to the middle.
        EXPECT_LT(largest_of(filtered(clamp, kind, 0.0, 1.0, 0.0) - (0.875 * p + 0.125 * q)), 1e-6);
    }
}

TEST(TransparentMap, ExactFiltersAreTheMeansOfTheDefinition) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1.0, 2.0), width(0.0, 1.2);
    constexpr int n = 400;
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (int i = 0; i < 12; ++i) {
            const ColorMap map = veil(wrap);
            const double f = place(random), u = width(random), v = width(random);
            Vec4d sum(0.0);
            for (int a = 0; a < n; ++a)
                for (int b = 0; b < n; ++b)
                    sum += defined(map, f + u * ((a + 0.5) / n - 0.5) + v * ((b + 0.5) / n - 0.5));
            const Vec4d mean = sum / double(n * n);
            EXPECT_LT(largest_of(filtered(map, FilterKind::trapezoid, f, u, v) - mean), 4e-3);
            sum = Vec4d(0.0);
            const double box = std::sqrt(u * u + v * v);
            for (int a = 0; a < n * n; ++a)
                sum += defined(map, f + box * ((a + 0.5) / (n * n) - 0.5));
            EXPECT_LT(largest_of(filtered(map, FilterKind::exact, f, u, v) - sum / double(n * n)),
                      1e-5);
        }
}

TEST(TransparentMap, OpaqueMapsAreKnown) {
    ColorMap map = veil(Wrap::clamp);
    EXPECT_FALSE(is_opaque(map));
    for (ColorStop& stop : map.stops) stop.alpha = 255;
    EXPECT_TRUE(is_opaque(map));
    EXPECT_EQ(evaluate_color(alpha_map(map), 0.3), Vec3d(1.0));
}

}  // namespace
}  // namespace burl
