// Maps that are one to one, and maps that are not: fans of more than a turn, rings wound twice
// round, triangles on each other, and borders that rounding moves.
#include "atlas/chart/covering.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "atlas/chart/planar_map.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

using Corners2 = std::array<Vec2d, 3>;

Corners2 corners_of(const Patch& patch, std::span<const Vec2d> places, std::size_t t) {
    const auto& [a, b, c] = patch.triangles[t];
    return {places[a], places[b], places[c]};
}

bool is_inside(const Corners2& c, const Vec2d& p, double margin) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2d along = c[(k + 1) % 3] - c[k];
        if (!(cross(along, p - c[k]) > margin * glm::length(along))) return false;
    }
    return true;
}

/// Whether some of many random places lie in two triangles, further than `margin` from their sides.
bool covers_twice_at_random(const Patch& patch, std::span<const Vec2d> places, double margin) {
    std::mt19937 random(1);
    const auto any = [&] { return double(random()) / 4294967296.0; };
    Vec2d low(1e300), high(-1e300);
    for (const Vec2d& p : places) low = glm::min(low, p), high = glm::max(high, p);
    for (int trial = 0; trial < 20000; ++trial) {
        const Vec2d p = low + (high - low) * Vec2d(any(), any());
        int count = 0;
        for (std::size_t t = 0; t < patch.triangles.size(); ++t)
            count += is_inside(corners_of(patch, places, t), p, margin) ? 1 : 0;
        if (count >= 2) return true;
    }
    return false;
}

std::vector<Vec2d> from_above(const Patch& patch) {
    std::vector<Vec2d> places;
    for (const Vec3d& p : patch.points) places.emplace_back(p.x, p.y);
    return places;
}

/// A fan of triangles round a point, with their outer ends at these angles.
Patch fan(const std::vector<double>& angles, double radius) {
    std::vector<Vec3d> points{{0.0, 0.0, 0.0}};
    std::vector<Triangle> triangles;
    for (const double angle : angles) {
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        if (points.size() < 3) continue;
        const auto last = std::uint32_t(points.size() - 1);
        triangles.push_back({0, last - 1, last});
    }
    return made::whole(made::mesh_of(points, triangles));
}

std::vector<double> turned(int count, double step) {
    std::vector<double> angles;
    for (int i = 0; i <= count; ++i) angles.push_back(step * i + 0.1);
    return angles;
}

TEST(Covering, FansOfMoreThanATurnCoverPlacesTwice) {
    for (int count = 3; count < 30; ++count)
        for (const double step : {0.25, 0.5, 1.0, 1.5}) {
            const Patch patch = fan(turned(count, step), 0.5);
            EXPECT_EQ(covers_twice(patch, from_above(patch), most_overlap),
                      count * step > 2.0 * std::numbers::pi + 1e-9)
                << count << " triangles of " << step;
        }
}

TEST(Covering, TwoWholeTurnsCoverEveryPlaceTwice) {
    // Both turns have the same borders, which cross nowhere.
    const Patch patch = fan(turned(8, 0.5 * std::numbers::pi), 0.5);
    EXPECT_TRUE(covers_twice(patch, from_above(patch), most_overlap));
}

TEST(Covering, SheetsAndPlatesWithHolesDoNot) {
    for (const std::uint32_t n : {1u, 5u, 12u}) {
        const Patch patch = made::whole(made::grid(n, n));
        EXPECT_FALSE(covers_twice(patch, from_above(patch), most_overlap)) << n;
        Mesh plate = made::grid(n, n);
        for (std::size_t t = 0; t + 8 < plate.triangles.size(); t += 7)
            plate.triangles.erase(plate.triangles.begin() + std::ptrdiff_t(t));
        plate = made::mesh_of(plate.positions, plate.triangles);
        const Patch holed = made::whole(plate);
        EXPECT_FALSE(covers_twice(holed, from_above(holed), most_overlap)) << n;
    }
}

TEST(Covering, ThinnerRegionsThanTheDepthAreAllowed) {
    // Two squares beside each other, joined at their upper edges by a bow, over each other by
    // `far`.
    for (const double far : {0.0, 1e-8, 1e-7, 1e-6, 1e-3}) {
        const double x = 1.0 - far;
        const Patch patch = made::whole(made::mesh_of(
            {{0, 0, 0},
             {1, 0, 0},
             {1, 1, 0},
             {0, 1, 0},
             {x, 0, 0},
             {2, 0, 0},
             {2, 1, 0},
             {x, 1, 0},
             {0, 2, 0},
             {2, 2, 0}},
            {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}, {3, 2, 8}, {8, 7, 6}, {8, 6, 9}}));
        EXPECT_EQ(covers_twice(patch, from_above(patch), most_overlap), far > most_overlap) << far;
    }
}

TEST(Covering, AgreesWithRandomPlaces) {
    int doubled = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        std::vector<double> angles{0.1};
        for (int i = 0; i < 9; ++i)
            angles.push_back(angles.back() + 0.2 + double(random()) / 4294967296.0);
        const Patch patch = fan(angles, 0.5);
        std::vector<Vec2d> places = from_above(patch);
        for (Vec2d& p : places) p *= 0.5 + double(random()) / 4294967296.0;
        const bool sampled = covers_twice_at_random(patch, places, 1e-3);
        doubled += sampled ? 1 : 0;
        EXPECT_GE(covers_twice(patch, places, most_overlap), sampled) << seed;
        EXPECT_EQ(covers_twice(patch, places, most_overlap),
                  angles.back() - angles.front() > 2.0 * std::numbers::pi)
            << seed;
    }
    EXPECT_GT(doubled, 5);
    EXPECT_LT(doubled, 55);
}

/// Two triangles on each other, both facing up, and four without area that join them.
Patch doubled_triangle(double height) {
    const Vec3d a(0.0), b(1.0, 0.0, 0.0), c(1.0, height, 0.0);
    return made::whole(
        made::mesh_of({a, b, c, a, b, c, a, a},
                      {{0, 1, 2}, {3, 4, 5}, {1, 0, 6}, {6, 0, 3}, {7, 3, 0}, {4, 3, 7}}));
}

TEST(PlanarMap, TrianglesOnEachOtherAreNoMapHoweverThin) {
    for (const double height : {0.3, 16.0 * frame_step, 2.0 * frame_step, frame_step})
        EXPECT_FALSE(map_planar(doubled_triangle(height))) << height;
    const Mesh one = made::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, frame_step, 0}}, {{0, 1, 2}});
    EXPECT_TRUE(map_planar(made::whole(one)));
}

}  // namespace
}  // namespace burl
