// Triangulation against areas: for a simple polygon the triangles are all wound as the polygon and
// sum to the shoelace area, which together means a partition.
#include "atlas/mesh/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace burl {
namespace {

double shoelace(const std::vector<Vec2d>& p) {
    double twice = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2d &a = p[i], &b = p[(i + 1) % p.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2.0;
}

/// Checks n - 2 triangles, none turned over, areas summing to the polygon's; in every orientation.
void expect_partition(const std::vector<Vec2d>& outline, bool flat_allowed = false) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Vec3d> corners;
        for (const Vec2d& p : outline) {
            Vec3d c(0.3 * p.x - 0.2 * p.y);  // a slanted plane
            c[(axis + 1) % 3] = p.x;
            c[(axis + 2) % 3] = p.y;
            corners.push_back(c);
        }
        PolygonTriangulator triangulate;
        const auto triangles = triangulate(corners);
        ASSERT_EQ(triangles.size(), outline.size() - 2);
        double sum = 0.0;
        for (const auto& [a, b, c] : triangles) {
            const double area = shoelace({outline[a], outline[b], outline[c]});
            EXPECT_GE(area, flat_allowed ? 0.0 : 1e-12);
            sum += area;
        }
        EXPECT_NEAR(sum, shoelace(outline), 1e-12 * std::abs(sum) + 1e-15);
        EXPECT_EQ(triangulate.forced(), 0u);
    }
}

TEST(Polygon, ConvexIsAFan) {
    PolygonTriangulator triangulate;
    const std::vector<Vec3d> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const auto triangles = triangulate(square);
    ASSERT_EQ(triangles.size(), 2u);
    EXPECT_EQ(triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
}

TEST(Polygon, ConcaveQuadFromEveryStart) {
    std::vector<Vec2d> arrow{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
    for (int start = 0; start < 4; ++start) {
        expect_partition(arrow);
        std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
    }
}

TEST(Polygon, StarsCombsAndSpirals) {
    std::vector<Vec2d> star, comb, spiral;
    for (int i = 0; i < 14; ++i) {
        const double angle = std::numbers::pi * i / 7.0, r = i % 2 ? 0.3 : 1.0;
        star.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    expect_partition(star);
    for (int i = 0; i < 20; ++i) {
        comb.emplace_back(i, 0.0);
        comb.emplace_back(i + 0.4, 0.0);
        comb.emplace_back(i + 0.5, 5.0);
        comb.emplace_back(i + 0.9, 5.0);
    }
    comb.emplace_back(20.0, 6.0);
    comb.emplace_back(0.0, 6.0);
    expect_partition(comb);
    for (int i = 0; i <= 60; ++i)
        spiral.emplace_back((1.0 + 0.1 * i) * std::cos(0.3 * i),
                            (1.0 + 0.1 * i) * std::sin(0.3 * i));
    for (int i = 60; i >= 0; --i)
        spiral.emplace_back((1.5 + 0.1 * i) * std::cos(0.3 * i),
                            (1.5 + 0.1 * i) * std::sin(0.3 * i));
    std::reverse(spiral.begin(), spiral.end());
    expect_partition(spiral);
}

TEST(Polygon, RandomStarShapedOnes) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> radius(0.2, 1.0);
    for (int n = 4; n < 60; ++n) {
        std::vector<Vec2d> outline;
        for (int i = 0; i < n; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / n, r = radius(random);
            outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        expect_partition(outline, true);
    }
}

TEST(Polygon, CollinearCornersGetTrianglesWithArea) {
    expect_partition({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {0, 3}});
    expect_partition({{0, 0}, {1, 0}, {2, 0}, {1, 1}});
    std::vector<Vec2d> sampled;  // every side of a square cut in ten
    for (int i = 0; i < 10; ++i) sampled.emplace_back(i, 0);
    for (int i = 0; i < 10; ++i) sampled.emplace_back(10, i);
    for (int i = 0; i < 10; ++i) sampled.emplace_back(10 - i, 10);
    for (int i = 0; i < 10; ++i) sampled.emplace_back(0, 10 - i);
    expect_partition(sampled);
}

TEST(Polygon, RepeatedCornersAndBridgedHoles) {
    expect_partition({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}, true);
    expect_partition({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 1}, {1, 1}, {0, 2}}, true);
    // A square with a square hole, joined by a bridge walked both ways.
    const std::vector<Vec2d> frame{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                                   {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    for (std::size_t start = 0; start < frame.size(); ++start) {
        std::vector<Vec2d> turned = frame;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(start),
                    turned.end());
        expect_partition(turned, true);
    }
}

TEST(Polygon, BrokenOnesStillGiveAllTriangles) {
    PolygonTriangulator triangulate;
    const std::vector<std::vector<Vec3d>> broken{
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},             // self-crossing
        {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},  // a point
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}},             // a line, walked both ways
        {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, -1, 0}, {3, 1, 0}}};
    for (const auto& polygon : broken) EXPECT_EQ(triangulate(polygon).size(), polygon.size() - 2);
}

TEST(Polygon, LargeRaggedOnes) {
    for (const double dent : {0.2, 0.99}) {
        std::vector<Vec3d> ragged;
        std::vector<Vec2d> outline;
        for (int i = 0; i < 20000; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 20000, r = i % 2 ? dent : 1.0;
            outline.emplace_back(r * std::cos(angle), r * std::sin(angle));
            ragged.emplace_back(outline.back(), 0.0);
        }
        PolygonTriangulator triangulate;
        double sum = 0.0;
        for (const auto& [a, b, c] : triangulate(ragged))
            sum += std::abs(shoelace({outline[a], outline[b], outline[c]}));
        EXPECT_NEAR(sum, shoelace(outline), 1e-9);
        EXPECT_EQ(triangulate.forced(), 0u);
    }
}

TEST(Polygon, AHopelessOneEnds) {
    std::vector<Vec3d> tangle;  // crosses itself everywhere
    for (int i = 0; i < 3000; ++i) tangle.emplace_back(i * 7919 % 3001, i * 104729 % 2999, 0.0);
    PolygonTriangulator triangulate;
    EXPECT_EQ(triangulate(tangle).size(), tangle.size() - 2);
    EXPECT_EQ(triangulate.forced(), 1u);
}

}  // namespace
}  // namespace burl
