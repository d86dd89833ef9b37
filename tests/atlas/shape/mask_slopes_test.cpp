// Gradients of masks against closed forms and against differences of the masks themselves.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "atlas/shape/crease_edges.h"
#include "atlas/shape/curvature.h"
#include "atlas/shape/nearest_surface.h"
#include "atlas/shape/occlusion.h"
#include "atlas/shape/point_masks.h"
#include "atlas/shape/texel_mask.h"
#include "tests/atlas/support/made_shapes.h"
#include "tests/atlas/support/shown_mesh.h"

namespace burl {
namespace {

using AskedPoints = std::span<const ShapePoint>;
using AskedValues = std::span<float>;

/// Compares gradients of a mask with its differences, in double over a step of 1e-3, along two
/// directions of each triangle.
template <class At>
void expect_gradients(const ShapeScene& shape, const PointSlopes& slopes, const At& value_at,
                      double tolerance) {
    std::vector<ShapePoint> points;
    for (std::uint32_t t = 0; t < shape.triangles().size(); ++t)
        points.push_back(shape.surface_point(t, {0.5, 0.2, 0.3}));
    std::vector<Vec3d> found(points.size());
    slopes(points, found);
    for (const ShapePoint& point : points) {
        const Vec3d slope = found[point.triangle];
        EXPECT_NEAR(glm::dot(slope, point.normal), 0.0, 1e-9);
        const auto& [a, b, c] = shape.triangles()[point.triangle];
        for (const std::uint32_t to : {b, c}) {
            const Vec3d step = 1e-3 * shape.diagonal() * (shape.points()[to] - shape.points()[a]);
            const double change = value_at(point.triangle, point.position + step) -
                                  value_at(point.triangle, point.position - step);
            EXPECT_NEAR(glm::dot(slope, 2.0 * step), change, tolerance);
        }
    }
}

/// Attributes that no affine function of the points gives.
Mesh marked_torus() {
    Mesh mesh = made::torus(1.0, 0.4, 12, 8);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) {
            mesh.corners.colors.push_back({unit(random), unit(random), unit(random), unit(random)});
            mesh.corners.uvs.push_back({unit(random), unit(random)});
            const Vec3d& at = mesh.positions[p];
            const Vec3d ring = glm::normalize(Vec3d(at.x, at.y, 0.0));
            mesh.corners.normals.push_back(Vec3f(glm::normalize(at - ring)));
        }
    return mesh;
}

TEST(MaskSlopes, OfAttributesAndNormalsAreThoseOfTheirInterpolation) {
    const Mesh mesh = marked_torus();
    const ShapeScene shape(mesh);
    const auto sum = [&](std::uint32_t t, const Vec3d& p, const auto& attributes) {
        const Vec3d weights = shape.weights_at(t, p);
        auto all = 0.0 * Vec4d(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& one = attributes[3 * t + k];
            for (int c = 0; c < one.length(); ++c) all[c] += weights[int(k)] * double(one[c]);
        }
        return all;
    };
    for (int c = 0; c < 4; ++c)
        expect_gradients(
            shape,
            [&](AskedPoints p, std::span<Vec3d> s) { vertex_color_slopes(mesh, shape, c, p, s); },
            [&](std::uint32_t t, const Vec3d& p) { return sum(t, p, mesh.corners.colors)[c]; },
            1e-12);
    for (int c = 0; c < 2; ++c)
        expect_gradients(
            shape,
            [&](AskedPoints p, std::span<Vec3d> s) { vertex_uv_slopes(mesh, shape, c, p, s); },
            [&](std::uint32_t t, const Vec3d& p) { return sum(t, p, mesh.corners.uvs)[c]; }, 1e-12);
    const Vec3d direction(0.48, -0.6, 0.64);
    expect_gradients(
        shape, [&](AskedPoints p, std::span<Vec3d> s) { facing_slopes(shape, p, direction, s); },
        [&](std::uint32_t t, const Vec3d& p) {
            return glm::dot(direction, glm::normalize(Vec3d(sum(t, p, mesh.corners.normals))));
        },
        1e-8);
}

TEST(MaskSlopes, OfFacingWithoutNormalsAreNought) {
    const Mesh mesh = made::torus(1.0, 0.4, 12, 8);
    const ShapeScene shape(mesh);
    std::vector<Vec3d> slopes(mesh.triangles.size(), Vec3d(9.0));
    facing_slopes(shape, made::middles(shape), {0, 0, 1}, slopes);
    for (const Vec3d& slope : slopes) EXPECT_EQ(slope, Vec3d(0.0));
}

TEST(MaskSlopes, OfHeightAreOneOverTheBox) {
    EXPECT_EQ(height_slope({{1, 2, 3}, {2, 6, 3.5}}, 1), Vec3d(0, 0.25, 0));
    EXPECT_EQ(height_slope({{1, 2, 3}, {2, 2, 3.5}}, 1), Vec3d(0.0));
    EXPECT_EQ(height_slope({{-1.5e308, 0, 0}, {1.5e308, 1, 1}}, 0).y, 0.0);
}

TEST(MaskSlopes, OfDistanceToEdgesLeadAwayFromTheNearest) {
    const Mesh cube = made::cuboid({0, 0, 0}, {1, 1, 1});
    const ShapeScene shape(cube);
    const CreaseEdges edges(shape, 0.5);
    // On the side z = 1, triangles 2 and 3, nearest to x = 0, then to y = 1, then beyond reach.
    const std::vector<ShapePoint> points{
        made::point_at(shape, 3, {0.125, 0.375, 1}), made::point_at(shape, 3, {0.5, 0.75, 1}),
        made::point_at(shape, 2, {0.75, 0.375, 1}), made::point_at(shape, 3, {0.4375, 0.5, 1})};
    std::vector<Vec3d> slopes(4);
    edge_distance_slopes(shape, edges, points, 0.4, slopes);
    EXPECT_LT(glm::distance(slopes[0], Vec3d(1, 0, 0)), 1e-5);
    EXPECT_LT(glm::distance(slopes[1], Vec3d(0, -1, 0)), 1e-5);
    EXPECT_LT(glm::distance(slopes[2], Vec3d(-1, 0, 0)), 1e-5);
    EXPECT_EQ(slopes[3], Vec3d(0.0));
}

/// Calls visit(gradient, point of the surface) for all texels of a mask with its gradients.
template <class Visit>
void for_slopes(const Shown& all, const ShapeMask& mask, TexelMaskOptions options,
                const Visit& visit) {
    options.slopes = true;
    const TexelField field = texel_mask(all.solid, all.owners(), all.shape, mask, options);
    for_texels(all, [&](auto x, auto y, auto t, const Vec3d& weights) {
        visit(field.slope(x, y), all.shape.surface_point(t, weights));
    });
}

TEST(MaskSlopes, ThatAreDifferencesAreRightForALinearMask) {
    const Vec3d along(0.3, -0.2, 1.0);
    const PointMask height = [&](AskedPoints points, AskedValues values) {
        for (std::size_t i = 0; i < points.size(); ++i)
            values[i] = float(2.0 + glm::dot(along, points[i].position));
    };
    for (const AtlasKind kind : {AtlasKind::quad, AtlasKind::patch})
        for (const double spacing : {0.0, 4.0}) {
            // A plane of 72 triangles, so that no neighbour faces another way.
            Mesh plane = made::grid(6, 6);
            for (Vec3d& p : plane.positions) p.z = 0.3 * p.x - 0.2 * p.y;
            const Shown all = shown(plane, kind, 128);
            double worst = 0.0;
            for_slopes(all, {height}, {spacing, 9.0f},
                       [&](const Vec3d& slope, const ShapePoint& at) {
                           const Vec3d expected = along - glm::dot(along, at.normal) * at.normal;
                           worst = std::max(worst, glm::distance(slope, expected));
                       });
            EXPECT_LT(worst, 0.05);  // a texel's tenth against cells of one texel and more
        }
}

TEST(MaskSlopes, AClosedFormIsTakenWhereThereIsOne) {
    const Shown all = shown(made::torus(1.0, 0.4, 16, 12), AtlasKind::quad, 64);
    const ShapeMask mask{[](AskedPoints, AskedValues values) { std::ranges::fill(values, 1.0f); },
                         [](AskedPoints points, std::span<Vec3d> slopes) {
                             for (std::size_t i = 0; i < points.size(); ++i)
                                 slopes[i] = points[i].position;
                         }};
    for_slopes(all, mask, {}, [](const Vec3d& slope, const ShapePoint& at) {
        ASSERT_LT(glm::distance(slope, at.position), 1e-6);
    });
}

TEST(MaskSlopes, ASliverMakesNoCliffOfNoise) {
    // A sheet with a sliver a millionth as high as it is long.
    const Mesh mesh = made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-6, 0}, {0.5, 1, 0}},
                                    {{0, 1, 2}, {0, 2, 3}, {1, 3, 2}});
    const Shown all = shown(mesh, AtlasKind::quad, 64);
    const PointMask noise = [](AskedPoints points, AskedValues values) {
        for (std::size_t i = 0; i < points.size(); ++i)
            values[i] = float(std::fmod(1e6 * std::abs(points[i].position.y), 1.0) * 0.01);
    };
    const double texel = 1.0 / 64;
    for_slopes(all, {noise}, {}, [&](const Vec3d& slope, const ShapePoint&) {
        ASSERT_LT(glm::length(slope), 0.2 / texel);
    });
}

TEST(MaskSlopes, OfOcclusionBesideAWallAreKnown) {
    // A floor that ends at a long wall of height 1: at x from it 1/2 + x / (2 sqrt(x^2 + 1)) of the
    // sky is open.
    const double far = 40.0;
    const Mesh mesh = made::both(made::sheet({0, -far, 0}, {2, 0, 0}, {0, 2 * far, 0}),
                                 made::sheet({0, -far, 0}, {0, 2 * far, 0}, {0, 0, 1}));
    const ShapeScene shape(mesh);
    const auto truth = [](double x) { return 0.5 / std::pow(x * x + 1.0, 1.5); };
    const ShapeMask open{
        [&](AskedPoints points, AskedValues values) { occlusion(shape, points, {2048}, values); }};
    std::vector<ShapePoint> points;
    for (double x = 0.2; x < 1.5; x += 0.1)
        points.push_back(made::point_at(shape, 0, {x, -far / 2.0, 0}));
    std::vector<Vec3d> slopes(points.size());
    // A long step: rays leave noise of a thousandth.
    mask_slopes(NearestSurface(shape), open, points, 0.1, slopes);
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += std::abs(slopes[i].x - truth(points[i].position.x));
    EXPECT_LT(sum / double(points.size()), 0.03);
}

TEST(MaskSlopes, OfCurvatureAreDifferencesOfTheMask) {
    const Shown all = shown(made::cuboid({0, 0, 0}, {1, 1, 1}), AtlasKind::quad, 256);
    const CurvatureTree tree(all.shape);
    const PointMask curved = [&](AskedPoints points, AskedValues values) {
        curvature(tree, points, 0.2, values);
    };
    double square = 0.0, error = 0.0;
    std::size_t texel = 0;
    for_slopes(all, {curved}, {4.0, 0.05f}, [&](const Vec3d& slope, const ShapePoint& at) {
        if (++texel % 61 != 0) return;
        const Vec3d u = glm::normalize(glm::cross(at.normal, Vec3d(0.3, 0.5, 0.7)));
        for (const Vec3d& way : {u, glm::cross(at.normal, u)}) {
            const std::vector<ShapePoint> both{
                made::point_at(all.shape, at.triangle, at.position - 2e-3 * way),
                made::point_at(all.shape, at.triangle, at.position + 2e-3 * way)};
            const double apart = glm::distance(both[0].position, both[1].position);
            if (apart < 3.9e-3) return;  // at a side of the triangle
            std::vector<float> values(2);
            curved(both, values);
            const double truth = double(values[1] - values[0]) / apart;
            square += truth * truth;
            error += std::pow(glm::dot(slope, way) - truth, 2.0);
        }
    });
    EXPECT_GT(square, 100.0);
    EXPECT_LT(std::sqrt(error / square), 0.4);
}

TEST(NearestSurface, IsTheNearestOfAllTriangles) {
    const Mesh mesh = made::torus(1.0, 0.4, 12, 8);
    const ShapeScene shape(mesh);
    const NearestSurface nearest(shape);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.5, 1.5);
    for (int i = 0; i < 60; ++i) {
        const Vec3d p(unit(random), unit(random), unit(random));
        const ShapePoint found = nearest(p);
        double best = 1e9;
        // All triangles at a grid of their points: no nearer than the nearest, and almost as near.
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (int u = 0; u <= 40; ++u)
                for (int v = 0; u + v <= 40; ++v) {
                    const Vec3d weights = Vec3d(40 - u - v, u, v) / 40.0;
                    Vec3d at(0.0);
                    for (int k = 0; k < 3; ++k)
                        at += weights[k] * mesh.positions[mesh.triangles[t][std::size_t(k)]];
                    best = std::min(best, glm::distance(at, p));
                }
        EXPECT_LT(glm::distance(found.position, p), best + 1e-4);
        EXPECT_GT(glm::distance(found.position, p), best - 0.02);
        const Vec3d weights = shape.weights_at(found.triangle, found.position);
        EXPECT_GE(std::min({weights.x, weights.y, weights.z}), -1e-9);
    }
    // A point of the surface is its own nearest.
    for (const ShapePoint& middle : made::middles(shape)) {
        const ShapePoint found = nearest(middle.position);
        EXPECT_EQ(found.triangle, middle.triangle);
        EXPECT_LT(glm::distance(found.position, middle.position), 1e-4);  // the inset
    }
}

}  // namespace
}  // namespace burl
