// Occlusion against closed forms, through walls as thin as a hundred thousandth of the mesh, and
// against 4096 rays.
#include "atlas/shape/occlusion.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/atlas/support/made_shapes.h"

namespace burl {
namespace {

std::vector<float> occluded(const ShapeScene& shape, const std::vector<ShapePoint>& points,
                            const OcclusionOptions& options = {}) {
    std::vector<float> values(points.size(), -1.0f);
    occlusion(shape, points, options, values);
    return values;
}

float openness_at(const Mesh& mesh, std::uint32_t t, const Vec3d& position,
                  const OcclusionOptions& options) {
    const ShapeScene shape(mesh);
    return occluded(shape, {made::point_at(shape, t, position)}, options)[0];
}

void expect_all(const Mesh& mesh, float value) {
    const ShapeScene shape(mesh);
    for (const float v : occluded(shape, made::middles(shape))) ASSERT_EQ(v, value);
}

TEST(Occlusion, IsNoneOnConvexMeshesWhereverTheyAre) {
    expect_all(made::sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 1.0f);
    expect_all(made::one_triangle(), 1.0f);
    for (const double scale : {1e-30, 1.0, 1e30}) {
        expect_all(made::placed(made::ball(4), scale, Vec3d(0.0)), 1.0f);
        expect_all(made::placed(made::ball(4), scale, scale * Vec3d(1e5, -2e5, 3e5)), 1.0f);
    }
    expect_all(made::cuboid({0, 0, 0}, {1, 2, 3e-4}), 1.0f);
}

/// Rotates about two axes by angles of 3-4-5 and 5-12-13 triangles.
Vec3d turned_aside(const Vec3d& p) {
    const Vec3d q(0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z);
    return {q.x, (5.0 * q.y - 12.0 * q.z) / 13.0, (12.0 * q.y + 5.0 * q.z) / 13.0};
}

TEST(Occlusion, IsFullInABoxUpToItsCorners) {
    for (const double height : {1.0, 1e-4}) {
        Mesh box = made::turned_inside_out(made::cuboid({0, 0, 0}, {1, 2, height}));
        for (Vec3d& p : box.positions) p = turned_aside(p);  // so that planes are rounded
        const ShapeScene shape(box);
        std::vector<ShapePoint> points = made::middles(shape);
        for (std::uint32_t t = 0; t < 12; ++t)
            for (int i = 0; i < 60; ++i) {
                const double along = i / 60.0;  // corners and edges
                points.push_back(shape.surface_point(t, {1.0 - along, along, 0.0}));
                points.push_back(shape.surface_point(t, {along, 0.0, 1.0 - along}));
                points.push_back(shape.surface_point(t, {-along, 0.4, 0.6}));
            }
        for (const float v : occluded(shape, points)) ASSERT_EQ(v, 0.0f);
    }
}

TEST(Occlusion, OfAWallThatLeans) {
    // A wall without end that stands on the floor at this angle leaves (1 - cos(angle)) / 2 open,
    // however near one is.
    for (const double angle : {0.5, 1.0, 0.5 * std::numbers::pi, 2.0, 2.8}) {
        const Vec3d up(-std::cos(angle), 0.0, std::sin(angle));
        const Mesh floor = made::sheet({-4, -4, 0}, {4, 0, 0}, {0, 8, 0});
        const Mesh wall = made::sheet({0, 2000, 0}, {0, -4000, 0}, 2000.0 * up);
        for (const double off : {0.5, 1.0, 1.5})
            EXPECT_NEAR(openness_at(made::both(floor, wall), 1, {-off, 0.5, 0}, {8192}),
                        (1.0 - std::cos(angle)) / 2.0, 0.004);
    }
}

Mesh disc_over_floor(double radius, double height) {
    std::vector<Vec3d> rim;
    std::vector<Triangle> fan;
    for (std::uint32_t i = 0; i < 400; ++i) {
        const double angle = made::full_turn * i / 400.0;
        rim.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
        if (i >= 2) fan.push_back({0, i - 1, i});
    }
    return made::both(made::sheet({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), made::mesh_of(rim, fan));
}

TEST(Occlusion, BelowADisc) {
    for (const double height : {0.2, 0.7, 3.0}) {
        const double hidden = 1.0 / (1.0 + height * height);
        EXPECT_NEAR(openness_at(disc_over_floor(1.0, height), 0, {-0.001, -0.001, 0}, {4096}),
                    1.0 - hidden, 0.003);
    }
    // Beyond the rays' length it hides nothing, within it all that it did.
    const Mesh mesh = disc_over_floor(1.0, 0.5);
    EXPECT_EQ(openness_at(mesh, 0, {0, 0, 0}, {512, 0.49}), 1.0f);
    EXPECT_NEAR(openness_at(mesh, 0, {0, 0, 0}, {512, 1.2}), 0.2, 0.01);
}

TEST(Occlusion, NothingLeaksBetweenPlates) {
    for (const double gap : {1e-3, 1e-4, 1e-5}) {
        const Mesh low = made::sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        const Mesh high = made::sheet({0, 0, gap}, {0, 1, 0}, {1, 0, 0});  // faces the other
        const ShapeScene shape(made::both(low, high));
        for (const float v : occluded(shape, made::middles(shape))) EXPECT_EQ(v, 0.0f);
        const ShapeScene outside(made::turned_inside_out(made::both(low, high)));
        for (const float v : occluded(outside, made::middles(outside))) EXPECT_EQ(v, 1.0f);
    }
}

TEST(Occlusion, NormalsOfShadingDoNotLookBelowTheSurface) {
    Mesh mesh = made::sheet({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Vec3f leaning = glm::normalize(Vec3f(1.0f, 0.0f, 0.2f));
    mesh.corners.normals.assign(6, leaning);
    const ShapeScene shape(mesh);
    const ShapePoint point = shape.surface_point(0, {0.4, 0.3, 0.3});
    EXPECT_NEAR(glm::distance(point.shading, Vec3d(leaning)), 0.0, 1e-7);
    EXPECT_EQ(point.normal, Vec3d(0, 0, 1));
    EXPECT_EQ(occluded(shape, {point})[0], 1.0f);
}

TEST(Occlusion, DefaultRaysAreWithinAHundredthOfTheTruth) {
    const ShapeScene shape(made::torus(1.0, 0.45, 40, 20));
    const std::vector<ShapePoint> points = made::middles(shape);
    const auto values = occluded(shape, points), truth = occluded(shape, points, {4096});
    double square = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        square += (values[i] - truth[i]) * (values[i] - truth[i]) / double(values.size());
        mean += truth[i] / double(values.size());
    }
    EXPECT_LT(std::sqrt(square), 0.01);
    EXPECT_GT(mean, 0.7);
    EXPECT_LT(mean, 0.97);
}

TEST(Occlusion, ThreadsDoNotMatter) {
    const Mesh mesh = made::torus(1.0, 0.45, 60, 30);
    const auto with_threads = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const ShapeScene shape(mesh);
        return occluded(shape, made::middles(shape));
    };
    EXPECT_EQ(with_threads(1), with_threads(4));
}

TEST(Occlusion, TrianglesWithoutAreaAreOpen) {
    for (const Mesh& mesh :
         {made::nasty(), made::mesh_of({{1, 1, 1}}, {{0, 0, 0}}),
          made::mesh_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {0, 0, 1}}), Mesh{}}) {
        const ShapeScene shape(mesh);
        const auto points = made::middles(shape);
        const auto values = occluded(shape, points);
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_GE(values[i], 0.0f);
            EXPECT_LE(values[i], 1.0f);
            if (shape.areas()[i] == 0.0) {
                EXPECT_EQ(values[i], 1.0f);
            }
        }
    }
}

}  // namespace
}  // namespace burl
