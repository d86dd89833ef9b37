// The exact filters against brute-force integration in long double, and the tables against them.
#include "procedural/color/map_filter.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "procedural/color/mip.h"
#include "procedural/color/sums.h"
#include "procedural/color/table.h"
#include "procedural/model/texture.h"

namespace burl {
namespace {

ColorMap jumping(Wrap wrap) {  // a jump inside, one across the wrap, unequal pieces
    return {wrap,
            {{0.1, {255, 0, 30}},
             {0.35, {20, 200, 90}},
             {0.35, {0, 10, 250}},
             {0.36, {240, 240, 10}},
             {0.9, {5, 90, 140}}}};
}

ColorMap smooth_wrap() {
    return {Wrap::repeat, {{0.0, {10, 20, 30}}, {0.5, {250, 200, 100}}}};
}

std::vector<ColorMap> maps() {
    return {jumping(Wrap::repeat),
            jumping(Wrap::clamp),
            smooth_wrap(),
            {Wrap::repeat, {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}}},
            {Wrap::clamp, {{0.0, {0, 0, 0}}, {1.0, {255, 255, 255}}}},
            {Wrap::repeat, {{0.3, {7, 77, 177}}}},
            {Wrap::clamp, {{0.5, {9, 9, 9}}, {0.5, {200, 200, 200}}}}};
}

/// Mean of c over f + wide U + narrow V with n x n midpoints.
Vec3d counted(const ColorMap& map, double f, const FilterWidths& w, int n) {
    const PreparedColorMap color(map);
    Vec3d sum(0.0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            sum += color(f + w.wide * ((i + 0.5) / n - 0.5) + w.narrow * ((j + 0.5) / n - 0.5));
    return sum / double(n * n);
}

double map_filter_distance(const Vec3d& a, const Vec3d& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

TEST(MapPieces, HasTheMapsColours) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-2.0, 3.0);
    for (const ColorMap& map : maps())
        for (int i = 0; i < 500; ++i) {
            const double f = uniform(random);
            EXPECT_LT(map_filter_distance(MapPieces(map).extended(f, f), evaluate_color(map, f)),
                      1e-14)
                << f;
        }
}

TEST(MapPieces, MarksJumps) {
    const MapPieces pieces(jumping(Wrap::clamp));
    int jumps = 0;
    for (const MapBreak& b : pieces.breaks())
        if (map_filter_distance(b.jump, Vec3d(0.0)) > 1e-6) {
            ++jumps;
            EXPECT_EQ(b.position, 0.35);
        }
    EXPECT_EQ(jumps, 1);
}

TEST(MapFilter, StopsNextToOneAnotherMakeAJump) {
    const double below_half = std::nextafter(0.5, 0.0), below_one = std::nextafter(1.0, 0.0);
    const Rgb8 a{255, 0, 30}, b{20, 200, 90}, c{0, 10, 250};
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const MapPieces near({wrap,
                              {{0.0, a},
                               {5e-324, b},
                               {1e-17, c},
                               {below_half, a},
                               {0.5, b},
                               {0.5 + 1e-8, c},
                               {below_one, c},
                               {1.0, b}}});
        const MapPieces jumps({wrap, {{0.0, a}, {0.0, c}, {0.5, a}, {0.5, c}, {1.0, c}, {1.0, b}}});
        for (const double f : {-0.3, 0.0, 1e-18, 0.1, 0.5, 0.7, below_one, 1.0, 1.4, 1e9 + 0.25})
            for (const double width : {0.0, 1e-12, 1e-3, 0.2, 7.0}) {
                const Vec3d box = box_filtered(near, f, width),
                            trapezoid = trapezoid_filtered(near, f, {width, 0.4 * width});
                for (const Vec3d& color : {box, trapezoid, near.first(f), near.second(f)})
                    ASSERT_TRUE(std::isfinite(color.x + color.y + color.z)) << f << " " << width;
                if (width < 1e-3) continue;  // it matters on which side of a jump f lies
                EXPECT_LT(map_filter_distance(box, box_filtered(jumps, f, width)), 1e-11) << f;
                EXPECT_LT(map_filter_distance(trapezoid,
                                              trapezoid_filtered(jumps, f, {width, 0.4 * width})),
                          1e-11)
                    << f;
            }
    }
}

TEST(MapFilter, AgreesWithCounting) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const ColorMap& map : maps()) {
        const MapPieces pieces(map);
        for (int i = 0; i < 60; ++i) {
            const double f = 4.0 * uniform(random) - 2.0;
            const double u = 3.0 * std::exp2(-9.0 * uniform(random));
            const double v = 3.0 * std::exp2(-9.0 * uniform(random));
            const FilterWidths w = FilterWidths::of(u, v);
            // Midpoints are off by a jump over n where a line of samples runs along it.
            EXPECT_LT(
                map_filter_distance(trapezoid_filtered(pieces, f, w), counted(map, f, w, 250)),
                5e-3)
                << f << " " << w.wide << " " << w.narrow;
        }
    }
}

/// The trapezoid from boxes: an integral over the narrow axis, by Gauss-Legendre on pieces so small
/// that halving them changes nothing.
Vec3d trapezoid_of_boxes(const MapPieces& map, double f, const FilterWidths& w, int pieces) {
    const double x = std::sqrt(0.6);
    Vec3d sum(0.0);
    for (int i = 0; i < pieces; ++i) {
        const double mid = ((i + 0.5) / pieces - 0.5) * w.narrow, half = 0.5 * w.narrow / pieces;
        sum += (5.0 * box_filtered(map, f + mid - x * half, w.wide) +
                8.0 * box_filtered(map, f + mid, w.wide) +
                5.0 * box_filtered(map, f + mid + x * half, w.wide)) /
               18.0;
    }
    return sum / double(pieces);
}

TEST(MapFilter, BoxIsTheIntegralOverItsPieces) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const ColorMap& map : maps()) {
        const MapPieces pieces(map);
        for (int i = 0; i < 300; ++i) {
            const double f = 4.0 * uniform(random) - 2.0,
                         w = std::exp2(-40.0 * uniform(random)) * 4.0;
            // Additivity: a box is the mean of its two parts, however it is cut.
            const double cut = uniform(random);
            const Vec3d left = box_filtered(pieces, f - 0.5 * w + 0.5 * cut * w, cut * w);
            const Vec3d right =
                box_filtered(pieces, f + 0.5 * w - 0.5 * (1.0 - cut) * w, (1.0 - cut) * w);
            const Vec3d whole = box_filtered(pieces, f, w);
            // f - w/2 is rounded to 2^-52: worth a jump times 2^-52 / w.
            EXPECT_LT(map_filter_distance(cut * left + (1.0 - cut) * right, whole),
                      1e-12 + 2e-15 / w)
                << f << " " << w;
        }
    }
}

TEST(MapFilter, TrapezoidIsTheMeanOfBoxesAtEveryRatio) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double worst = 0.0;
    for (const ColorMap& map : maps()) {
        const MapPieces pieces(map);
        for (int i = 0; i < 200; ++i) {
            const double f = 4.0 * uniform(random) - 2.0;
            const double wide = std::exp2(-20.0 * uniform(random)) * 8.0;
            const FilterWidths w{wide, wide * std::exp2(-30.0 * uniform(random))};
            const Vec3d reference = trapezoid_of_boxes(pieces, f, w, 512);
            // The reference itself meets a box's kinks: an error of (narrow / 512)^2 at most.
            const double slack =
                30.0 * std::pow(w.narrow / 512, 2) + 4.0 * w.narrow / wide / 512 / 512;
            const double error =
                map_filter_distance(trapezoid_filtered(pieces, f, w), reference) - slack;
            worst = std::max(worst, error);
            EXPECT_LT(error, 2e-7) << f << " " << w.wide << " " << w.narrow;
        }
    }
    EXPECT_GT(worst, -1.0);
}

TEST(MapFilter, ConstantStaysConstant) {
    const Vec3d color = evaluate_color({Wrap::clamp, {{0.0, {7, 77, 177}}}}, 0.0);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const ColorMap map{wrap, {{0.2, {7, 77, 177}}, {0.7, {7, 77, 177}}}};
        const MapPieces pieces(map);
        const ColorMip mip(map);
        const ColorSums sums(map, false), thrice(map, true);
        for (int i = 0; i < 500; ++i) {
            const double f = 20.0 * uniform(random) - 10.0,
                         w = std::exp2(20.0 * uniform(random) - 15.0);
            EXPECT_LT(
                map_filter_distance(trapezoid_filtered(pieces, f, {w, w * uniform(random)}), color),
                1e-12);
            EXPECT_LT(map_filter_distance(mip(f, w), color), 1e-12);
            EXPECT_LT(map_filter_distance(sums(f, w), color), 1e-11) << f << " " << w;
            EXPECT_LT(map_filter_distance(thrice(f, w), color), 1e-11) << f << " " << w;
        }
    }
}

TEST(MapFilter, RepeatIsAsExactFarOut) {
    const MapPieces pieces(jumping(Wrap::repeat));
    for (const double whole : {1e3, 1e6, 1e9, -1e9})
        for (const double t : {0.25, 0.34375, 0.875})  // exact in binary at 1e9, too
            for (const FilterWidths w :
                 {FilterWidths{0.5, 0.25}, {2.5, 0.5}, {0.001, 0.0003}, {1e6, 3.0}})
                EXPECT_LT(map_filter_distance(trapezoid_filtered(pieces, whole + t, w),
                                              trapezoid_filtered(pieces, t, w)),
                          1e-12);
}

TEST(MapFilter, WideFootprintsReachTheMeanOrTheHalves) {
    const MapPieces repeat(jumping(Wrap::repeat)), clamp(jumping(Wrap::clamp));
    EXPECT_LT(map_filter_distance(box_filtered(repeat, 0.3, 1e12), repeat.mean()), 1e-10);
    const Vec3d ends = 0.5 * (clamp.extended(-1.0, -1.0) + clamp.extended(2.0, 2.0));
    EXPECT_LT(map_filter_distance(box_filtered(clamp, 0.3, 1e300), ends), 1e-9);
    EXPECT_LT(map_filter_distance(trapezoid_filtered(clamp, 0.3, {1e300, 1e299}), ends), 1e-6);
    const Vec3d low = clamp.extended(-1.0, -1.0);
    EXPECT_EQ(trapezoid_filtered(clamp, -1e200, {1e10, 1.0}), low);
    EXPECT_EQ(box_filtered(repeat, NAN, 0.1), repeat.extended(0.0, 0.0));
}

TEST(MapFilter, ZeroWidthIsTheColour) {
    for (const ColorMap& map : maps())
        for (const double f : {-0.7, 0.0, 0.1, 0.35, 0.36, 0.9, 1.0, 1.35})
            EXPECT_LT(map_filter_distance(trapezoid_filtered(MapPieces(map), f, {0.0, 0.0}),
                                          evaluate_color(map, f)),
                      1e-14)
                << f;
}

TEST(ColorSums, AgreesWithTheExactBoxToAnEntry) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const ColorMap& map : maps()) {
        const MapPieces pieces(map);
        const ColorSums sums(map, false), thrice(map, true);
        for (int i = 0; i < 300; ++i) {
            const double f = 6.0 * uniform(random) - 3.0,
                         w = std::exp2(-7.0 * uniform(random)) * 4.0;
            const double entry = 1.0 / ColorSums::entry_count;
            const Vec3d exact = box_filtered(pieces, f, w);
            EXPECT_LT(map_filter_distance(sums(f, w), exact), 1.5 * entry / w) << f << " " << w;
            EXPECT_LT(map_filter_distance(thrice(f, w), sums(f, w)), 1e-11) << f << " " << w;
        }
    }
}

TEST(ColorMip, AgreesWithTheExactBoxOnItsOwnEntries) {
    const ColorMap map = smooth_wrap();
    const MapPieces pieces(map);
    const ColorMip mip(map);
    for (int level = 0; level <= ColorMip::finest; ++level) {
        const double width = std::ldexp(1.0, level - ColorMip::finest);
        for (double f = 0.5 * width; f < 1.0; f += width * std::max(1.0, std::floor(0.07 / width)))
            EXPECT_LT(map_filter_distance(mip(f, width), box_filtered(pieces, f, width)), 1e-12)
                << f << " " << width;
    }
}

}  // namespace
}  // namespace burl
