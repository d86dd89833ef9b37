// Maps with free outlines: isometries where there are any, better than a projection known in closed
// form where there are none, and the same every time.
#include "atlas/outline/free_map.h"

#include <gtest/gtest.h>

#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

/// A grid of columns x rows squares, its points moved by `bend` from (x, y) in 0..1.
template <class Bend>
Patch bent_grid(std::uint32_t columns, std::uint32_t rows, const Bend& bend) {
    Mesh mesh = made::grid(columns, rows);
    for (Vec3d& p : mesh.positions) p = bend(p.x, p.y * columns / rows);
    return made::whole(mesh);
}

/// A sheet rolled up as a spiral about z: developable, so that it unrolls to turns of an annulus.
Patch ring_sector(double angle) {
    return bent_grid(80, 6, [&](double x, double y) {
        const double r = 1.0 + 0.4 * y, a = angle * x;
        return Vec3d(r * std::cos(a), r * std::sin(a), 0.001 * a);
    });
}

/// A cap of a unit sphere up to an angle from its pole, with rings of 6, 12, 18, ... triangles.
Mesh cap(double angle, std::uint32_t rings) {
    std::vector<Vec3d> positions{{0.0, 0.0, 1.0}};
    std::vector<Triangle> triangles;
    const auto at = [](std::uint32_t ring, std::uint32_t i) {
        return ring == 0 ? 0u : 1 + 3 * ring * (ring - 1) + i % (6 * ring);
    };
    for (std::uint32_t r = 1; r <= rings; ++r)
        for (std::uint32_t i = 0; i < 6 * r; ++i) {
            const double a = std::numbers::pi * i / (3.0 * r), t = angle * r / rings;
            positions.push_back(
                {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)});
        }
    for (std::uint32_t r = 1; r <= rings; ++r)
        for (std::uint32_t side = 0; side < 6; ++side)
            for (std::uint32_t k = 0; k < r; ++k) {
                const std::uint32_t out = side * r + k, in = side * (r - 1) + k;
                triangles.push_back({at(r - 1, in), at(r, out), at(r, out + 1)});
                if (k + 1 < r)
                    triangles.push_back({at(r - 1, in), at(r, out + 1), at(r - 1, in + 1)});
            }
    return made::mesh_of(positions, triangles);
}

/// The energy of a patch's map.
double energy_of(const Patch& patch, std::span<const Vec2d> places) {
    std::vector<Vec2d> gradient(places.size());
    return IsometryEnergy(patch)(places, gradient);
}

/// Lambert's equal-area projection of a point of the unit sphere from its pole (1772).
Vec2d equal_area(const Vec3d& p) {
    return Vec2d(p.x, p.y) * std::sqrt(2.0 / (1.0 + p.z));
}

TEST(FreeMap, DevelopableSheetsKeepTheirEdges) {
    const Patch patch = bent_grid(20, 12, [](double x, double y) {
        const double a = 1.5 * x;  // a quarter of a tube of radius 1, 1.5 round and 0.8 long
        return Vec3d(std::cos(a), std::sin(a), 0.8 * y);
    });
    const auto map = map_freely(patch, {.iterations = 300, .least_gain = 1e-6});
    ASSERT_TRUE(map);
    EXPECT_LT(map->energy, 1.0 + 1e-6);
    for (const Triangle& t : patch.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            const double length = glm::distance(patch.points[a], patch.points[b]);
            EXPECT_NEAR(glm::distance(map->places[a], map->places[b]), length, 3e-3 * length);
        }
}

TEST(FreeMap, CapsAreFlatterThanByLambert) {
    for (const double angle : {0.3, 0.8, 1.2}) {
        const Patch patch = made::whole(cap(angle, 10));
        std::vector<Vec2d> lambert;
        for (const Vec3d& p : patch.points) lambert.push_back(equal_area(p));
        const auto map = map_freely(patch, {.iterations = 100, .least_gain = 1e-5});
        ASSERT_TRUE(map);
        EXPECT_LE(map->energy, energy_of(patch, lambert)) << angle;
        EXPECT_GT(map->energy, 1.0) << angle;
        EXPECT_FALSE(overlaps_itself(patch, map->places)) << angle;
        EXPECT_DOUBLE_EQ(map->energy, energy_of(patch, map->places));
    }
}

TEST(FreeMap, DescentsThatCannotReachTheWantedEnergyEndEarly) {
    // A finger: a tube of radius 1, 12 long and closed at one end, whose border is its other end.
    Mesh finger = cap(1.0, 20);
    for (Vec3d& p : finger.positions) {
        const double along = 13.0 * std::acos(std::min(p.z, 1.0)), from_axis = std::hypot(p.x, p.y);
        const double shrink = from_axis > 0.0 ? std::min(along, 1.0) / from_axis : 0.0;
        p = {shrink * p.x, shrink * p.y, std::min(1.0 - along, 0.0)};
    }
    const Patch patch = made::whole(finger);
    const auto all = map_freely(patch), wanted = map_freely(patch, {.wanted = 1.04});
    ASSERT_TRUE(all && wanted);
    EXPECT_EQ(wanted->iterations, 2);
    EXPECT_EQ(all->iterations, 60);
    EXPECT_GT(all->energy, 1.04);
    const Patch flat = made::whole(cap(0.3, 10));
    EXPECT_EQ(map_freely(flat, {.wanted = 1.04})->places, map_freely(flat)->places);
}

TEST(FreeMap, LargePatchesAreMappedAsWellAsSmallOnes) {
    // The same cap with 600, 9,600 and 38,400 triangles: the larger ones by way of coarse ones.
    const FreeMapOptions options{.iterations = 100, .least_gain = 1e-4};
    const auto reference = map_freely(made::whole(cap(0.8, 10)), options);
    ASSERT_TRUE(reference);
    for (const std::uint32_t rings : {40u, 80u}) {
        const Patch patch = made::whole(cap(0.8, rings));
        const auto map = map_freely(patch, options);
        ASSERT_TRUE(map) << rings;
        EXPECT_NEAR(map->energy, reference->energy, 0.05 * (reference->energy - 1.0)) << rings;
        EXPECT_DOUBLE_EQ(map->energy, energy_of(patch, map->places));
        EXPECT_FALSE(overlaps_itself(patch, map->places));
        for (std::size_t t = 0; t < patch.triangles.size(); ++t)
            ASSERT_GT(made::uv_area(patch, map->places, t), 0.0);
    }
}

TEST(FreeMap, RandomDisksAreOneToOneAndTheSameEveryTime) {
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        const Patch patch = made::random_disk(seed, 120);
        const auto map = map_freely(patch);
        ASSERT_TRUE(map) << seed;
        for (std::size_t t = 0; t < patch.triangles.size(); ++t)
            EXPECT_GT(made::uv_area(patch, map->places, t), 0.0);
        EXPECT_EQ(map_freely(patch)->places, map->places);
    }
}

TEST(FreeMap, TheGradientIsThatOfTheEnergy) {
    const Patch patch = made::random_disk(3, 60);
    std::vector<Vec2d> places = map_freely(patch, {.iterations = 2})->places;
    std::vector<Vec2d> gradient(places.size());
    IsometryEnergy{patch}(places, gradient);
    for (std::size_t v = 0; v < places.size(); v += 5)
        for (int axis = 0; axis < 2; ++axis) {
            const double step = 1e-6 * std::sqrt(area_of(patch)), kept = places[v][axis];
            places[v][axis] = kept + step;
            const double above = energy_of(patch, places);
            places[v][axis] = kept - step;
            const double below = energy_of(patch, places);
            places[v][axis] = kept;
            EXPECT_NEAR((above - below) / (2.0 * step), gradient[v][axis],
                        1e-5 * (1.0 + std::abs(gradient[v][axis])));
        }
}

TEST(FreeMap, StepsEndWhereATriangleCollapses) {
    const Patch patch = made::whole(made::one_triangle());
    const std::vector<Vec2d> places{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
    const std::vector<Vec2d> down{{0.0, 0.0}, {0.0, 0.0}, {0.0, -2.0}};
    const std::vector<Vec2d> up{{0.0, 0.0}, {0.0, 0.0}, {0.0, 2.0}};
    EXPECT_DOUBLE_EQ(IsometryEnergy(patch).step_to_collapse(places, down), 0.5);
    EXPECT_GT(IsometryEnergy(patch).step_to_collapse(places, up), 1e300);
    const std::vector<Vec2d> flipped{{0.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
    EXPECT_GT(energy_of(patch, flipped), 1e300);
}

TEST(FreeMap, UnrolledSpiralsOverlapBeyondAFullTurn) {
    for (const double turns : {0.5, 0.9, 1.2}) {
        const Patch patch = ring_sector(2.0 * std::numbers::pi * turns);
        std::vector<Vec2d> unrolled;
        for (const Vec3d& p : patch.points) unrolled.emplace_back(p.x, p.y);
        EXPECT_EQ(overlaps_itself(patch, unrolled), turns > 1.0) << turns;
        const auto map = map_freely(patch, {.iterations = 400, .least_gain = 1e-6});
        ASSERT_TRUE(map);
        EXPECT_EQ(overlaps_itself(patch, map->places), turns > 1.0) << turns;
    }
}

}  // namespace
}  // namespace burl
