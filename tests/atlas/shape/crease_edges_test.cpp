// Distances to creases against all edges of a box, borders and triangles without area.
#include "atlas/shape/crease_edges.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/atlas/support/made_shapes.h"

namespace burl {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

std::vector<float> distances(const ShapeScene& shape, const std::vector<ShapePoint>& points,
                             double angle, double farthest = endless) {
    std::vector<float> values(points.size(), -1.0f);
    edge_distance(shape, CreaseEdges(shape, angle), points, farthest, values);
    return values;
}

/// Distance from a point of a box's surface to the nearest of its twelve edges.
double to_edge_of_box(const Vec3d& p, const Vec3d& size) {
    double best = endless;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const double du = p[u] - (corner & 1 ? size[u] : 0.0);
            const double dv = p[v] - (corner & 2 ? size[v] : 0.0);
            best = std::min(best, std::sqrt(du * du + dv * dv));
        }
    return best;
}

TEST(EdgeDistance, OfABox) {
    const Vec3d size(1.0, 2.0, 0.3), offset(1000.0, 0.0, -1000.0);
    const ShapeScene shape(made::cuboid(offset, offset + size));
    EXPECT_EQ(CreaseEdges(shape, 0.5).count(), 12u);  // no diagonal
    std::vector<ShapePoint> points;
    for (std::uint32_t t = 0; t < 12; ++t)
        for (double u = 0.01; u < 1.0; u += 0.07)
            for (double v = 0.01; u + v < 1.0; v += 0.07)
                points.push_back(shape.surface_point(t, {1.0 - u - v, u, v}));
    const auto values = distances(shape, points, 0.5);
    const auto capped = distances(shape, points, 0.5, 0.1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double expected = to_edge_of_box(points[i].position - offset, size);
        EXPECT_NEAR(values[i], expected, 1e-6);
        EXPECT_NEAR(capped[i], std::min(expected, 0.1), 1e-6);
    }
}

TEST(EdgeDistance, ReachesPastOtherTrianglesInAStraightLine) {
    // A fine torus has no creases; with a small angle all its edges are.
    const ShapeScene shape(made::torus(1.0, 0.4, 40, 20));
    EXPECT_EQ(CreaseEdges(shape, 1.0).count(), 0u);
    for (const float v : distances(shape, made::middles(shape), 1.0))
        EXPECT_FLOAT_EQ(v, float(shape.diagonal()));
    // Its rim of squares: compare with all segments one by one.
    const CreaseEdges edges(shape, 0.25);
    ASSERT_GT(edges.count(), 100u);
    ASSERT_LT(edges.count(), 2000u);
    const auto points = made::middles(shape);
    const auto values = distances(shape, points, 0.25);
    for (std::size_t i = 0; i < points.size(); i += 13) {
        const Vec3d p = shape.to_unit(points[i].position);
        double best = endless;
        for (const Segment& s : edges.segments())
            for (int k = 0; k <= 1000; ++k)
                best = std::min(best, glm::distance(p, glm::mix(s[0], s[1], k / 1000.0)));
        EXPECT_NEAR(values[i] / shape.diagonal(), best, 2e-6);
    }
}

TEST(EdgeDistance, BordersCountAndAngles) {
    const ShapeScene open(made::sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}));
    EXPECT_EQ(CreaseEdges(open, 0.1).count(), 4u);
    EXPECT_NEAR(distances(open, {made::point_at(open, 0, {0.3, 0.4, 0})}, 0.1)[0], 0.3, 1e-6);
    const ShapeScene triangle(made::one_triangle());
    EXPECT_EQ(CreaseEdges(triangle, 3.0).count(), 3u);

    for (const double turn : {0.3, 1.0, 2.0}) {
        const Vec3d down(std::cos(turn), 0.0, -std::sin(turn));
        const Mesh roof =
            made::mesh_of({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, down}, {{0, 1, 2}, {1, 0, 3}});
        EXPECT_EQ(CreaseEdges(ShapeScene(roof), turn - 0.01).count(), 5u);
        EXPECT_EQ(CreaseEdges(ShapeScene(roof), turn + 0.01).count(), 4u);
        Mesh twisted = roof;  // one triangle the other way round
        std::swap(twisted.triangles[1][0], twisted.triangles[1][1]);
        EXPECT_EQ(CreaseEdges(ShapeScene(twisted), turn - 0.01).count(), 5u);
        EXPECT_EQ(CreaseEdges(ShapeScene(twisted), turn + 0.01).count(), 4u);
    }
}

TEST(EdgeDistance, TrianglesWithoutAreaAndThreads) {
    // A repeated point changes nothing; three triangles at an edge make it one.
    Mesh mesh = made::square();
    mesh.triangles.push_back({0, 2, 2});
    EXPECT_EQ(CreaseEdges(ShapeScene(mesh), 0.5).count(), 4u);
    mesh.positions.push_back({0.3, 0.5, 0.0});
    mesh.triangles.push_back({0, 2, 4});
    EXPECT_EQ(CreaseEdges(ShapeScene(mesh), 0.5).count(), 7u);
    const ShapeScene point(made::mesh_of({{1, 1, 1}}, {{0, 0, 0}}));
    EXPECT_EQ(distances(point, made::middles(point), 0.5)[0], 1.0f);

    const ShapeScene shape(made::nasty());
    const auto with_threads = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return distances(shape, made::middles(shape), 0.2);
    };
    EXPECT_EQ(with_threads(1), with_threads(4));
    for (const float v : with_threads(2)) EXPECT_TRUE(v >= 0.0f && v <= float(shape.diagonal()));
}

}  // namespace
}  // namespace burl
