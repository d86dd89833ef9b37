// Strips against a decoder of their own, written after the definition in OpenGL.
#include "atlas/mesh/triangle_strips.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/atlas/support/made_shapes.h"

namespace burl {
namespace {

/// The triangle begun at its lowest vertex, in its own direction.
Triangle turned(Triangle t) {
    std::ranges::rotate(t, std::ranges::min_element(t));
    return t;
}

std::vector<Triangle> sorted(std::vector<Triangle> triangles) {
    std::ranges::transform(triangles, triangles.begin(), turned);
    std::ranges::sort(triangles);
    return triangles;
}

/// The triangles with an area of a strip, as OpenGL draws them.
std::vector<Triangle> drawn(std::span<const std::uint32_t> strip) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
        const std::uint32_t a = strip[i], b = strip[i + 1], c = strip[i + 2];
        if (a == b || b == c || c == a) continue;
        triangles.push_back(i % 2 == 0 ? Triangle{a, b, c} : Triangle{a, c, b});
    }
    return triangles;
}

std::vector<Triangle> drawn(const TriangleStrips& strips) {
    std::vector<Triangle> all;
    std::size_t begin = 0;
    for (const std::size_t end : strips.ends) {
        const std::vector<Triangle> some =
            drawn(std::span(strips.vertices).subspan(begin, end - begin));
        all.insert(all.end(), some.begin(), some.end());
        begin = end;
    }
    return all;
}

void expect_same(const std::vector<Triangle>& triangles) {
    const TriangleStrips strips = triangle_strips(triangles);
    EXPECT_EQ(sorted(drawn(strips)), sorted(triangles));
    EXPECT_EQ(sorted(drawn(joined(strips))), sorted(triangles));
    EXPECT_EQ(strips.left_out, 0u);
}

/// A flat grid of squares, each cut by the same diagonal.
Mesh grid(std::uint32_t columns, std::uint32_t rows) {
    std::vector<Vec3d> points;
    std::vector<Triangle> triangles;
    for (std::uint32_t j = 0; j <= rows; ++j)
        for (std::uint32_t i = 0; i <= columns; ++i) points.emplace_back(i, j, 0.0);
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
            triangles.push_back({a, a + 1, b + 1});
            triangles.push_back({a, b + 1, b});
        }
    return made::mesh_of(points, triangles);
}

TEST(TriangleStrips, OneRowOfSquaresIsOneStrip) {
    const Mesh mesh = grid(20, 1);
    const TriangleStrips strips = triangle_strips(mesh.triangles);
    EXPECT_THAT(strips.ends, testing::ElementsAre(42u));
    EXPECT_EQ(strips.border_loops, 1u);
    expect_same(mesh.triangles);
}

TEST(TriangleStrips, AGridTakesLittleMoreThanOneIndexATriangle) {
    const Mesh mesh = grid(40, 30);
    const std::size_t count = joined(triangle_strips(mesh.triangles)).size();
    EXPECT_LT(double(count), 1.2 * double(mesh.triangles.size()));
    expect_same(mesh.triangles);
}

TEST(TriangleStrips, ATetrahedronIsOneStrip) {
    const std::vector<Triangle> tetrahedron{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    const TriangleStrips strips = triangle_strips(tetrahedron);
    EXPECT_THAT(strips.ends, testing::ElementsAre(6u));
    EXPECT_EQ(strips.border_loops, 0u);
    expect_same(tetrahedron);
}

TEST(TriangleStrips, AFanTurnsWithOneIndexATriangle) {
    std::vector<Triangle> fan;
    for (std::uint32_t i = 1; i < 9; ++i) fan.push_back({0, i, i + 1});
    const TriangleStrips strips = triangle_strips(fan);
    EXPECT_EQ(strips.ends.size(), 1u);
    EXPECT_LE(strips.vertices.size(), 2u + 2u * fan.size());
    expect_same(fan);
}

TEST(TriangleStrips, HoldMeshesOfEveryKind) {
    expect_same(made::torus(2.0, 0.5, 60, 20).triangles);
    expect_same(made::cylinder(1.0, 3.0, 30, 7).triangles);
    expect_same(
        made::both(made::cuboid({0, 0, 0}, {1, 1, 1}), made::torus(4.0, 0.5, 9, 5)).triangles);
    expect_same(made::turned_inside_out(made::torus(2.0, 0.5, 13, 7)).triangles);
}

TEST(TriangleStrips, BordersAreCountedByTheirLoops) {
    EXPECT_EQ(triangle_strips(made::torus(2.0, 0.5, 12, 8).triangles).border_loops, 0u);
    EXPECT_EQ(triangle_strips(made::cylinder(1.0, 3.0, 12, 4).triangles).border_loops, 2u);
    EXPECT_EQ(triangle_strips(std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}).border_loops,
              3u);
    EXPECT_EQ(triangle_strips(std::vector<Triangle>{{0, 1, 2}, {0, 3, 4}}).border_loops, 2u)
        << "triangles that share a point alone have a border each";
}

// Triangles thrown together at random: edges of many triangles, of both directions, and twins.
TEST(TriangleStrips, HoldTrianglesWithoutAnyStructure) {
    std::mt19937 random(7);
    for (int round = 0; round < 50; ++round) {
        std::vector<Triangle> triangles;
        for (int i = 0; i < 60; ++i) {
            const auto one = [&] { return std::uint32_t(random() % 9); };
            const Triangle t{one(), one(), one()};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
        }
        expect_same(triangles);
    }
}

TEST(TriangleStrips, RepeatedVerticesAreCountedAndLeftOut) {
    const std::vector<Triangle> triangles{{0, 1, 2}, {1, 1, 2}, {2, 1, 3}, {4, 4, 4}};
    const TriangleStrips strips = triangle_strips(triangles);
    EXPECT_EQ(strips.left_out, 2u);
    EXPECT_EQ(sorted(drawn(strips)), sorted({{0, 1, 2}, {2, 1, 3}}));
    StripCounts counts;
    counts.add(strips, triangles.size(), 4);
    EXPECT_EQ(counts.triangles, 2u);
    EXPECT_EQ(counts.strips, 1u);
}

TEST(TriangleStrips, OfNothingAreNone) {
    const TriangleStrips strips = triangle_strips({});
    EXPECT_TRUE(strips.ends.empty());
    EXPECT_TRUE(joined(strips).empty());
}

}  // namespace
}  // namespace burl
