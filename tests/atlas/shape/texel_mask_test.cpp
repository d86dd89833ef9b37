// Masks at all texels: exact where a mask is linear, gutters on their triangle, occlusion within a
// hundredth; and the masks that a point has by itself.
#include "atlas/shape/texel_mask.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>

#include "atlas/shape/occlusion.h"
#include "atlas/shape/point_masks.h"
#include "tests/atlas/support/made_shapes.h"
#include "tests/atlas/support/shown_mesh.h"

namespace burl {
namespace {

Image<float> values_of(const Shown& all, const PointMask& mask,
                       const TexelMaskOptions& options = {}) {
    return texel_mask(all.solid, all.owners(), all.shape, {mask}, options).values;
}

const std::vector<AtlasKind> kinds{AtlasKind::quad, AtlasKind::length, AtlasKind::patch};

TEST(TexelMask, OfALinearMaskIsExactAndGuttersStayOnTheirTriangle) {
    const PointMask height = [](std::span<const ShapePoint> points, std::span<float> values) {
        for (std::size_t i = 0; i < points.size(); ++i)
            values[i] = float(2.0 + points[i].position.z + 0.3 * points[i].position.x);
    };
    for (const AtlasKind kind : kinds) {
        const Shown all = shown(made::torus(1.0, 0.4, 12, 8), kind, 128);
        for (const double spacing : {0.0, 4.0}) {
            const Image<float> image = values_of(all, height, {spacing, 9.0f});
            std::size_t texels = 0, outside = 0;
            for_texels(all, [&](auto x, auto y, auto t, const Vec3d& weights) {
                double expected = 2.0;
                const Vec3d on = onto_triangle(weights);
                for (int k = 0; k < 3; ++k) {
                    const Vec3d& p = all.mesh.positions[all.mesh.triangles[t][std::size_t(k)]];
                    expected += on[k] * (p.z + 0.3 * p.x);
                }
                ASSERT_NEAR(image(x, y), expected, 1e-4);  // the inset
                ++texels, outside += on != weights;
            });
            EXPECT_GT(texels, 128u * 128u / 2);
            EXPECT_GT(outside, 0u);
        }
    }
}

TEST(TexelMask, OfOcclusionIsWithinAHundredthOfTheTruthAtAFifthOfThePoints) {
    for (const AtlasKind kind : kinds) {
        // A plate through the ring of a torus, so that occlusion also jumps within triangles.
        const Shown all = shown(made::both(made::torus(1.0, 0.4, 24, 16),
                                           made::cuboid({-0.2, -0.2, -1.5}, {2.0, 0.2, 1.5})),
                                kind, 256);
        std::atomic<std::size_t> asked{0};
        const PointMask open = [&](std::span<const ShapePoint> points, std::span<float> values) {
            asked += points.size();
            occlusion(all.shape, points, {}, values);
        };
        const Image<float> image = values_of(all, open);
        std::vector<ShapePoint> points;
        std::vector<float> found;
        std::size_t texel = 0;
        for_texels(all, [&](auto x, auto y, auto t, const Vec3d& weights) {
            if (++texel % 37 != 0) return;
            points.push_back(all.shape.surface_point(t, weights));
            found.push_back(image(x, y));
        });
        std::vector<float> truth(points.size());
        occlusion(all.shape, points, {2048}, truth);
        double square = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i)
            square += (found[i] - truth[i]) * (found[i] - truth[i]) / double(truth.size());
        EXPECT_LT(std::sqrt(square), 0.01);
        EXPECT_LT(asked.load(), texel / 3);
    }
}

TEST(TexelMask, ThreadsDoNotMatterNorDoBadTriangles) {
    for (const Mesh& mesh : {made::torus(1.0, 0.4, 24, 16), made::nasty(), made::one_triangle()}) {
        const Shown all = shown(mesh, AtlasKind::quad, 128);
        const PointMask open = [&](std::span<const ShapePoint> points, std::span<float> values) {
            occlusion(all.shape, points, {32}, values);
        };
        const auto with_threads = [&](std::size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            return values_of(all, open);
        };
        const Image<float> one = with_threads(1);
        EXPECT_TRUE(one == with_threads(4));
        for (const float v : one.pixels()) ASSERT_TRUE(v >= 0.0f && v <= 1.0f);
    }
}

TEST(PointMasks, FacingAndHeight) {
    const Mesh mesh = made::cuboid({1, 2, 3}, {2, 4, 3.5});
    const ShapeScene shape(mesh);
    const auto points = made::middles(shape);
    std::vector<float> up(points.size()), height(points.size());
    facing(points, {0, 0, 1}, up);
    height_in_box(points, bounding_box(mesh), 2, height);
    for (std::size_t t = 0; t < points.size(); ++t) {
        EXPECT_NEAR(up[t], t < 2 ? -1.0 : t < 4 ? 1.0 : 0.0, 1e-7);
        EXPECT_NEAR(height[t], (points[t].position.z - 3.0) / 0.5, 1e-6);
    }
    const Mesh flat = made::square();
    std::vector<float> middle(2);
    height_in_box(made::middles(ShapeScene(flat)), bounding_box(flat), 2, middle);
    EXPECT_EQ(middle, std::vector<float>(2, 0.5f));
}

TEST(PointMasks, PiecesByConnectionAndByPart) {
    Mesh mesh = made::both(made::ball(1), made::placed(made::ball(2), 1.0, {5, 0, 0}));
    const auto connected = piece_values(mesh, PieceKind::connected, 3);
    ASSERT_EQ(connected.size(), 32u + 128u);
    for (std::size_t t = 0; t < connected.size(); ++t) {
        EXPECT_EQ(connected[t], connected[t < 32 ? 0 : 32]);
        EXPECT_TRUE(connected[t] >= 0.0f && connected[t] < 1.0f);
    }
    EXPECT_NE(connected[0], connected[32]);
    EXPECT_NE(connected[0], piece_values(mesh, PieceKind::connected, 4)[0]);
    mesh.parts = {{"a", 0, 10}, {"b", 10, 150}};
    const auto parts = piece_values(mesh, PieceKind::part, 3);
    EXPECT_EQ(parts[0], parts[9]);
    EXPECT_NE(parts[9], parts[10]);
    EXPECT_EQ(parts[10], parts[159]);
}

TEST(PointMasks, ColoursAndTextureCoordinatesAreInterpolated) {
    Mesh mesh = made::square();
    const ShapeScene shape(mesh);
    const std::vector<ShapePoint> points{shape.surface_point(0, {0.5, 0.3, 0.2}),
                                         shape.surface_point(1, {0.1, 0.2, 0.7})};
    std::vector<Vec4f> colors(2);
    std::vector<Vec2d> uvs(2, Vec2d(5.0));
    vertex_color(mesh, shape, points, colors);
    vertex_uv(mesh, shape, points, uvs);
    EXPECT_EQ(colors[1], Vec4f(1.0f));
    EXPECT_EQ(uvs[1], Vec2d(0.0));
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) {
            const Vec3d& at = mesh.positions[p];
            mesh.corners.colors.push_back(Vec4f(at.x, at.y, 0.25f, 1.0f));
            mesh.corners.uvs.push_back({3.0 * at.x, at.y - at.x});
        }
    vertex_color(mesh, shape, points, colors);
    vertex_uv(mesh, shape, points, uvs);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3d& at = points[i].position;
        EXPECT_NEAR(glm::distance(colors[i], Vec4f(at.x, at.y, 0.25f, 1.0f)), 0.0, 1e-6);
        EXPECT_NEAR(glm::distance(uvs[i], Vec2d(3.0 * at.x, at.y - at.x)), 0.0, 1e-12);
    }
}

}  // namespace
}  // namespace burl
