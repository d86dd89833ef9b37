// Maps of disks onto rectangles: one to one, exact where there is an exact answer, never worse
// after the descent, and the same every time.
#include "atlas/chart/rectangle_map.h"

#include <gtest/gtest.h>

#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

/// A flat rectangle of width x 1, its inner points moved at random.
Mesh flat_rectangle(double width, std::uint32_t columns, std::uint32_t rows, double jitter) {
    Mesh mesh = made::grid(columns, rows);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-jitter, jitter);
    for (Vec3d& p : mesh.positions) {
        const double x = p.x * columns, y = p.y * columns;
        const bool inner = x > 0.5 && x < columns - 0.5 && y > 0.5 && y < rows - 0.5;
        p = {(x + (inner ? any(random) : 0.0)) * width / columns,
             (y + (inner ? any(random) : 0.0)) / rows, 0.0};
    }
    return mesh;
}

TEST(RectangleMap, FlatRectangleIsItsOwnMap) {
    for (const double width : {1.0, 3.0}) {
        Patch patch = made::whole(flat_rectangle(width, 12, 8, 0.3));
        const auto map = map_onto_rectangle(patch);
        ASSERT_TRUE(map);
        made::expect_fills_square(patch, map->uv);
        // D is quadratic about its minimum: points are within 3e-4 of their place, as below.
        EXPECT_NEAR(map->stretch.distortion(), 1.0, 1e-7);
        // Affine: (u,v) is (x/width, y) up to a quarter turn of the square.
        const std::uint32_t first = patch.start(patch.loops[0][map->corners[0]]);
        const std::uint32_t second = patch.start(patch.loops[0][map->corners[1]]);
        const std::uint32_t fourth = patch.start(patch.loops[0][map->corners[3]]);
        const Vec3d u = patch.points[second] - patch.points[first];
        const Vec3d v = patch.points[fourth] - patch.points[first];
        for (std::size_t i = 0; i < patch.points.size(); ++i) {
            const Vec3d p = patch.points[first] + map->uv[i].x * u + map->uv[i].y * v;
            EXPECT_LT(glm::length(p - patch.points[i]), 3e-4) << i;
        }
    }
}

TEST(RectangleMap, RandomDisksAreMappedOneToOne) {
    for (std::uint32_t seed = 20; seed < 40; ++seed) {
        Patch patch = made::random_disk(seed, 40 + 13 * (seed % 7));
        const auto map = map_onto_rectangle(patch);
        ASSERT_TRUE(map) << seed;
        made::expect_sound(patch);
        made::expect_fills_square(patch, map->uv);
        EXPECT_GE(map->stretch.distortion(), 1.0 - 1e-12);
        EXPECT_EQ(map->stretch.distortion(), StretchMeasure(patch)(map->uv).distortion());
    }
}

TEST(RectangleMap, BorderStaysOnItsSides) {
    Patch patch = made::random_disk(50, 120);
    const auto map = map_onto_rectangle(patch);
    ASSERT_TRUE(map);
    const std::array<Vec2d, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(map->uv[patch.start(patch.loops[0][map->corners[i]])], square[i]);
    int slid = 0;
    for (std::size_t v = 0; v < patch.points.size(); ++v) {
        const Vec2d q = map->uv[v];
        for (const auto& [side, axis, value] : {std::tuple(1, 1, 0.0), std::tuple(2, 0, 1.0),
                                                std::tuple(4, 1, 1.0), std::tuple(8, 0, 0.0)}) {
            EXPECT_EQ((map->sides[v] & side) != 0, q[axis] == value);
        }
    }
    const auto start = harmonic_map(patch, map->corners);
    ASSERT_TRUE(start);
    for (const HalfEdge h : patch.loops[0])
        slid += start->uv[patch.start(h)] != map->uv[patch.start(h)];
    EXPECT_GT(slid, 10);
}

TEST(RectangleMap, DescentNeverRaisesTheEnergy) {
    for (const std::uint32_t seed : {60u, 61u, 62u}) {
        Patch patch = made::random_disk(seed, 150);
        const auto choice = search_corners(patch);
        ASSERT_TRUE(choice);
        split_chords(patch, side_masks(patch, choice->corners));
        auto map = harmonic_map(patch, choice->corners);
        ASSERT_TRUE(map);
        const double start = map->stretch.distortion();
        double before = start;
        for (int i = 0; i < 12; ++i) {
            descend(patch, *map, {.iterations = 1});
            EXPECT_LE(map->stretch.distortion(), before);
            before = map->stretch.distortion();
        }
        // With the proportions given, their energy falls instead.
        const double aspect = 2.0;
        const auto energy = [&] { return map->stretch.x / aspect + map->stretch.y * aspect; };
        const double other = energy();
        EXPECT_GT(descend(patch, *map, {.iterations = 10, .aspect = aspect}), 0);
        EXPECT_LT(energy(), other);
        // The weighted anisotropy falls at the stretch's cost.
        const StretchMeasure measure(patch);
        const double anisotropy = measure.anisotropy(map->uv, aspect), stretch = energy();
        EXPECT_GT(descend(patch, *map, {.iterations = 10, .aspect = aspect, .anisotropy = 5.0}), 0);
        EXPECT_LT(measure.anisotropy(map->uv, aspect), 0.98 * anisotropy);
        const double area2 = map->stretch.area * map->stretch.area;
        EXPECT_LT(0.5 * energy() / area2 + 5.0 * measure.anisotropy(map->uv, aspect),
                  0.5 * stretch / area2 + 5.0 * anisotropy);
        made::expect_fills_square(patch, map->uv);
        EXPECT_LT(before, 0.98 * start);
    }
}

TEST(RectangleMap, RelaxingLowersTheStretchAndKeepsTheBorder) {
    for (const std::uint32_t seed : {60u, 61u, 62u}) {
        Patch patch = made::random_disk(seed, 150);
        const auto choice = search_corners(patch);
        ASSERT_TRUE(choice);
        split_chords(patch, side_masks(patch, choice->corners));
        auto map = harmonic_map(patch, choice->corners);
        ASSERT_TRUE(map);
        const RectangleMap start = *map;
        relax(patch, weighted_edges(patch), *map);
        EXPECT_LT(map->stretch.distortion(), start.stretch.distortion());
        EXPECT_EQ(map->stretch.distortion(), StretchMeasure(patch)(map->uv).distortion());
        for (const HalfEdge h : patch.loops[0])
            EXPECT_EQ(map->uv[patch.start(h)], start.uv[patch.start(h)]);
        made::expect_fills_square(patch, map->uv);
    }
    // What cannot be repaired is not descended on.
    Patch disk = made::random_disk(60, 150);
    EXPECT_FALSE(map_onto_rectangle(disk, {.wanted = 1.0001}));
    EXPECT_EQ(disk.triangles.size(), 150u);
}

TEST(RectangleMap, DescentFindsAMinimum) {
    // At a minimum no vertex can move for the better; with few iterations it could still.
    Patch patch = made::random_disk(70, 100);
    auto map = map_onto_rectangle(patch, {.iterations = 400});
    ASSERT_TRUE(map);
    const StretchMeasure measure(patch);
    const double best = map->stretch.distortion();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1e-3, 1e-3);
    for (std::size_t v = 0; v < patch.points.size(); ++v) {
        if (map->sides[v] != 0) continue;
        auto moved = map->uv;
        moved[v] += Vec2d{any(random), any(random)};
        EXPECT_GT(measure(moved).distortion(), best * (1.0 - 1e-6));
    }
}

TEST(RectangleMap, SameBitsEveryTimeAndAtPowersOfTwo) {
    const Patch disk = made::random_disk(80, 130);
    Patch a = disk, b = disk, scaled = disk;
    for (Vec3d& p : scaled.points) p *= 0x1p-20;
    const auto first = map_onto_rectangle(a), again = map_onto_rectangle(b);
    const auto small = map_onto_rectangle(scaled);
    ASSERT_TRUE(first && again && small);
    EXPECT_EQ(first->uv, again->uv);
    EXPECT_EQ(first->uv, small->uv);
    EXPECT_EQ(a.triangles, b.triangles);
}

TEST(RectangleMap, SliversAndFoldsStayOneToOne) {
    Mesh thin = made::grid(30, 6);
    for (Vec3d& p : thin.positions) p *= Vec3d(1.0, 1e-5, 1e-5);
    Patch slivers = made::whole(thin);
    auto map = map_onto_rectangle(slivers);
    ASSERT_TRUE(map);
    made::expect_fills_square(slivers, map->uv);
    Patch fan = made::whole(made::fan(200));
    map = map_onto_rectangle(fan);
    ASSERT_TRUE(map);
    made::expect_fills_square(fan, map->uv);
    Mesh folded = made::grid(16, 16);
    for (Vec3d& p : folded.positions) p.z = std::abs(p.x - 0.5) * 20.0;
    Patch fold = made::whole(folded);
    map = map_onto_rectangle(fold);
    ASSERT_TRUE(map);
    made::expect_fills_square(fold, map->uv);
    // Triangles without any area in the middle of a sheet.
    Mesh flat = made::grid(8, 8);
    for (std::size_t i = 0; i < 3; ++i) flat.positions[40 + i] = flat.positions[40];
    Patch pinched = made::whole(flat);
    map = map_onto_rectangle(pinched);
    ASSERT_TRUE(map);
    made::expect_fills_square(pinched, map->uv);
}

TEST(RectangleMap, RefusesWhatHasNoFourCornersOrIsNoDisk) {
    for (const Mesh& mesh : {made::one_triangle(), made::ball(1), made::tube(6, 2, 1.0)}) {
        Patch patch = made::whole(mesh);
        EXPECT_FALSE(map_onto_rectangle(patch));
        EXPECT_EQ(patch.triangles.size(), mesh.triangles.size());
    }
    Patch square = made::whole(made::square());
    const auto map = map_onto_rectangle(square);
    ASSERT_TRUE(map);
    EXPECT_NEAR(map->stretch.distortion(), 1.0, 1e-12);
}

}  // namespace
}  // namespace burl
