// Curvature of planes, spheres, cylinders, tori and creases; triangles in balls against a fine
// subdivision.
#include "atlas/shape/curvature.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>

#include "atlas/shape/disc_overlap.h"
#include "tests/atlas/support/made_shapes.h"

namespace burl {
namespace {

/// Sums over n^2 small triangles, each counted where its middle lies in the ball.
SurfacePiece by_subdivision(const std::array<Vec3d, 3>& corners, double radius, int n) {
    const Vec3d u = (corners[1] - corners[0]) / double(n),
                v = (corners[2] - corners[0]) / double(n);
    const double small = 0.5 * glm::length(glm::cross(u, v));
    SurfacePiece sum;
    const auto add = [&](const Vec3d& middle) {
        if (glm::length(middle) > radius) return;
        sum.area += small, sum.moment += small * middle;
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; i + j < n; ++j) {
            add(corners[0] + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v);
            if (i + j + 1 < n) add(corners[0] + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v);
        }
    return sum;
}

TEST(PieceInBall, AgreesWithSubdivision) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
    int cut = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::array<Vec3d, 3> corners;
        for (Vec3d& p : corners) p = {coordinate(random), coordinate(random), coordinate(random)};
        const Vec3d normal =
            glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
        const double radius = 0.2 + 0.8 * std::abs(coordinate(random));
        const SurfacePiece exact = piece_in_ball(corners, normal, radius);
        const SurfacePiece sum = by_subdivision(corners, radius, 300);
        EXPECT_NEAR(exact.area, sum.area, 2e-3);
        EXPECT_LT(glm::distance(exact.moment, sum.moment), 2e-3);
        cut += exact.area > 0.01;
    }
    EXPECT_GT(cut, 100);
}

TEST(PieceInBall, OfLargeTriangles) {
    const double third = 1.0 / std::sqrt(3.0);
    const std::array<Vec3d, 3> round{{{100, 0, 0.6}, {-100, 200, 0.6}, {-100, -200, 0.6}}};
    EXPECT_NEAR(piece_in_ball(round, {0, 0, 1}, 1.0).area, std::numbers::pi * 0.64, 1e-12);
    const std::array<Vec3d, 3> octant{{{9, 0, 0}, {0, 9, 0}, {0, 0, 0}}};
    const SurfacePiece quarter = piece_in_ball(octant, {0, 0, 1}, 1.0);
    EXPECT_NEAR(quarter.area, 0.25 * std::numbers::pi, 1e-14);
    EXPECT_NEAR(glm::distance(quarter.moment, Vec3d(1.0 / 3.0, 1.0 / 3.0, 0.0)), 0.0, 1e-14);
    const Vec3d diagonal(third);
    const std::array<Vec3d, 3> beyond{{{9, 0, 0}, {0, 9, 0}, {0, 0, 9}}};
    EXPECT_EQ(piece_in_ball(beyond, diagonal, 1.0).area, 0.0);
}

std::vector<float> curved(const ShapeScene& shape, const std::vector<ShapePoint>& points,
                          double radius) {
    std::vector<float> values(points.size(), -9.0f);
    curvature(CurvatureTree(shape), points, radius, values);
    return values;
}

TEST(Curvature, OfAPlaneIsNone) {
    for (const Mesh& mesh : {made::sheet({0, 0, 0}, {1, 0, 1}, {0, 1, 2}), made::one_triangle()}) {
        const ShapeScene shape(mesh);
        for (const double radius : {0.01, 0.3, 10.0})
            for (const float v : curved(shape, made::middles(shape), radius))
                EXPECT_NEAR(v, 0.0, 1e-9);
    }
}

TEST(Curvature, OfASphereIsOneOverItsRadius) {
    for (const double scale : {1e-30, 1.0, 1e20}) {
        const Mesh ball = made::placed(made::ball(6), scale, scale * Vec3d(3, 4, 5));
        const ShapeScene shape(ball), hollow(made::turned_inside_out(ball));
        const std::vector<ShapePoint> points{shape.surface_point(7, Vec3d(1.0 / 3.0)),
                                             shape.surface_point(30001, {0.9, 0.1, 0.0})};
        const std::vector<ShapePoint> within{hollow.surface_point(7, Vec3d(1.0 / 3.0))};
        for (const double share : {0.2, 0.5, 0.8}) {
            for (const float v : curved(shape, points, share * scale)) EXPECT_NEAR(v, share, 0.003);
            EXPECT_NEAR(curved(hollow, within, share * scale)[0], -share, 0.003);
        }
    }
}

TEST(Curvature, OfACylinderIsHalf) {
    const ShapeScene shape(made::cylinder(2.0, 8.0, 360, 160));
    const std::vector<ShapePoint> points{shape.surface_point(2 * (80 * 360 + 11), {0.5, 0.2, 0.3})};
    for (const double radius : {0.3, 0.6})
        EXPECT_NEAR(curved(shape, points, radius)[0], radius / 4.0, 0.02 * radius / 4.0);
}

TEST(Curvature, OfATorusInAndOut) {
    const double R = 1.0, r = 0.4, radius = 0.1;
    const ShapeScene shape(made::torus(R, r, 400, 200));
    const auto at_row = [&](std::uint32_t row) {
        const std::vector<ShapePoint> points{shape.surface_point(2 * (400 * row), {0.5, 0.2, 0.3})};
        return curved(shape, points, radius)[0] / radius;
    };
    EXPECT_NEAR(at_row(0), 0.5 * (1.0 / r + 1.0 / (R + r)), 0.04);
    EXPECT_NEAR(at_row(50), 0.5 / r, 0.04);  // the top, flat along the ring
    EXPECT_NEAR(at_row(100), 0.5 * (1.0 / r - 1.0 / (R - r)), 0.04);
}

TEST(Curvature, OnACreaseIsOneOfItsAngleWhateverTheScale) {
    // Two half discs whose barycentres lie 4r / (3 pi) off the crease.
    for (const double turn : {-0.7, 0.2, 0.4, 0.8}) {
        const Vec3d down(std::cos(turn), 0.0, -std::sin(turn));
        const ShapeScene shape(made::both(made::sheet({-1, -1, 0}, {1, 0, 0}, {0, 2, 0}),
                                          made::sheet({0, -1, 0}, down, {0, 2, 0})));
        const std::vector<ShapePoint> points{made::point_at(shape, 1, {0, 0.1, 0}),
                                             made::point_at(shape, 2, {0, 0.1, 0})};
        for (const double radius : {0.01, 0.1, 0.5})
            for (const float v : curved(shape, points, radius))
                EXPECT_NEAR(v, 16.0 / (3.0 * std::numbers::pi) * std::sin(0.5 * turn), 2e-3);
    }
    const ShapeScene cube(made::cuboid({0, 0, 0}, {1, 1, 1}));
    EXPECT_EQ(curved(cube, {made::point_at(cube, 2, {1, 0.5, 1})}, 0.1)[0], 1.0f);
}

TEST(Curvature, OtherSideOfAPlateDoesNotCount) {
    const ShapeScene shape(made::cuboid({0, 0, 0}, {1, 1, 0.01}));
    const std::vector<ShapePoint> points{made::point_at(shape, 2, {0.5, 0.4, 0.01})};
    EXPECT_NEAR(curved(shape, points, 0.2)[0], 0.0, 1e-9);
}

/// Curvature as the sum over all triangles.
double by_all_triangles(const ShapeScene& shape, const ShapePoint& point, double radius) {
    SurfacePiece sum;
    Vec3d facing(0.0);
    for (std::size_t t = 0; t < shape.triangles().size(); ++t) {
        const Vec3d& normal = shape.normals()[t];
        if (!(glm::dot(normal, point.normal) > -std::sqrt(0.5))) continue;
        std::array<Vec3d, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = shape.points()[shape.triangles()[t][k]] - shape.to_unit(point.position);
        const SurfacePiece piece = piece_in_ball(corners, normal, radius / shape.diagonal());
        sum.area += piece.area, sum.moment += piece.moment, facing += piece.area * normal;
    }
    const double depth = -glm::dot(sum.moment / sum.area, glm::normalize(facing));
    return std::clamp(4.0 * depth * shape.diagonal() / radius, -1.0, 1.0);
}

TEST(Curvature, HierarchyGivesTheSumOverAllTriangles) {
    // The ball about a point of the thin torus also holds the far side of its tube.
    for (const double tube : {0.4, 0.05}) {
        const ShapeScene shape(made::torus(1.0, tube, 60, 40));
        const std::vector<ShapePoint> points = made::middles(shape);
        const std::vector<float> values = curved(shape, points, 0.4);
        for (std::size_t i = 0; i < points.size(); i += 97)
            EXPECT_NEAR(values[i], by_all_triangles(shape, points[i], 0.4), 1e-6);
    }
}

TEST(Curvature, ThreadsAndLinesDoNotMatter) {
    const auto with_threads = [&](const Mesh& mesh, std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const ShapeScene shape(mesh);
        return curved(shape, made::middles(shape), 0.3);
    };
    const Mesh torus = made::torus(1.0, 0.45, 60, 30);
    EXPECT_EQ(with_threads(torus, 1), with_threads(torus, 4));
    for (const float v : with_threads(made::nasty(), 2)) EXPECT_LE(std::abs(v), 1.0f);
    const Mesh line = made::mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}});
    EXPECT_EQ(with_threads(line, 2), std::vector<float>{0.0f});
}

}  // namespace
}  // namespace burl
