// Tangents against maps whose derivatives are known.
#include "app/surface/tangents.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "app/export/vertices.h"
#include "app/pipeline/pipeline.h"
#include "app/surface/normals.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

/// One triangle in the plane z = 0, facing +z; its UVs are `map` of (x, y), v downwards.
std::vector<Vec4f> tangents_of(const glm::dmat2& map, const Vec3f& normal = {0, 0, 1}) {
    const std::vector<Vec3d> positions{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    const std::vector<Triangle> triangles{{0, 1, 2}};
    std::vector<Vec2d> uvs;
    for (const Vec3d& p : positions) uvs.push_back(map * Vec2d(p));
    return corner_tangents(positions, triangles, uvs, std::vector<Vec3f>(3, normal));
}

glm::dmat2 rows(double a, double b, double c, double d) {
    return {{a, c}, {b, d}};
}

TEST(Tangents, PointToGrowingU) {
    // Image right is x, image up (falling v) is y: the plain chart.
    for (const Vec4f& t : tangents_of(rows(0.1, 0, 0, -0.1))) EXPECT_EQ(t, Vec4f(1, 0, 0, 1));
    // Mirrored: right is -x, up still y; and up is -y.
    for (const Vec4f& t : tangents_of(rows(-0.1, 0, 0, -0.1))) EXPECT_EQ(t, Vec4f(-1, 0, 0, -1));
    for (const Vec4f& t : tangents_of(rows(0.1, 0, 0, 0.1))) EXPECT_EQ(t, Vec4f(1, 0, 0, -1));
    // Turned by 90 degrees: right is y, up is -x.
    for (const Vec4f& t : tangents_of(rows(0, 0.1, 0.1, 0))) EXPECT_EQ(t, Vec4f(0, 1, 0, 1));
    // Stretched and sheared: u grows fastest across the lines of equal v.
    const Vec4f sheared = tangents_of(rows(0.1, 0.3, 0, -0.1))[0];
    EXPECT_EQ(sheared, Vec4f(1, 0, 0, 1));
}

TEST(Tangents, FollowNormalsThatPointInside) {
    for (const Vec4f& t : tangents_of(rows(0.1, 0, 0, -0.1), {0, 0, -1}))
        EXPECT_EQ(t, Vec4f(1, 0, 0, -1));
}

TEST(Tangents, ArePerpendicularUnitVectorsWhateverTheMap) {
    const Vec3f slanted(glm::normalize(Vec3d(0.5, 0.2, 1)));
    const double none = 0.0, huge = 1e300;
    for (const glm::dmat2& map : {rows(0.1, 0, 0, -0.1), rows(0, 0, 0, 0), rows(1, 1, 1, 1),
                                  rows(huge, 0, 0, huge), rows(none / none, 0, 0, 1)}) {
        for (const Vec4f& t : tangents_of(map, slanted)) {
            EXPECT_NEAR(glm::length(Vec3d(t)), 1.0, 1e-6);
            EXPECT_NEAR(glm::dot(Vec3d(t), Vec3d(slanted)), 0.0, 1e-6);
            EXPECT_EQ(std::abs(t.w), 1.0f);
        }
    }
}

/// (position, uv, normal, w) in a row per corner of the atlas's mesh.
struct Baked {
    Pipeline pipeline;
    std::vector<Vec3f> normals;
    std::vector<Vec4f> tangents;

    explicit Baked(AtlasKind kind) : pipeline(sphere_mesh(12, 24)) {
        Recipe recipe;
        recipe.atlas.kind = kind;
        recipe.atlas.size = 256;
        pipeline.set_recipe(recipe);
        const Mesh& mesh = pipeline.atlas_mesh();
        normals = corner_normals(mesh, 40.0);
        tangents =
            corner_tangents(mesh.positions, mesh.triangles, corner_uvs(pipeline.atlas()), normals);
    }
};

TEST(Tangents, LeaveTheVerticesOfAPatchAtlasWhole) {
    Baked baked(AtlasKind::patch);
    const Mesh& mesh = baked.pipeline.atlas_mesh();
    const Atlas& atlas = baked.pipeline.atlas();
    const auto plain = export_vertices(mesh, atlas, baked.normals);
    const auto with = export_vertices(mesh, atlas, baked.normals, baked.tangents);
    ASSERT_EQ(plain.size(), 1u);
    EXPECT_EQ(with[0].positions.size(), plain[0].positions.size());
    EXPECT_EQ(with[0].indices, plain[0].indices);
    ASSERT_EQ(with[0].tangents.size(), with[0].positions.size());
    for (std::size_t c = 0; c < with[0].indices.size(); ++c)
        EXPECT_EQ(with[0].tangents[with[0].indices[c]], baked.tangents[c]);
    EXPECT_TRUE(plain[0].tangents.empty());
}

TEST(Tangents, AgreeWithTheMapsOwnDerivative) {
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad, AtlasKind::length}) {
        Baked baked(kind);
        const Mesh& mesh = baked.pipeline.atlas_mesh();
        double mean = 0.0;
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            // v and the bitangent's share: going up in the image is going along cross(n, t) w.
            const auto& [a, b, c] = mesh.triangles[t];
            const Vec3d e = mesh.positions[b] - mesh.positions[a];
            const Vec3d f = mesh.positions[c] - mesh.positions[a];
            const auto& at = baked.pipeline.atlas().corners[t];
            const Vec2d g = at[1] - at[0], h = at[2] - at[0];
            const double area = g.x * h.y - g.y * h.x;
            if (std::abs(area) < 1e-9) continue;
            const Vec3d along_u = glm::normalize((h.y * e - g.y * f) / area);
            const Vec3d up = -(g.x * f - h.x * e) / area;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d n(baked.normals[3 * t + k]), tangent(baked.tangents[3 * t + k]);
                EXPECT_GT(glm::dot(glm::cross(n, tangent) * double(baked.tangents[3 * t].w), up),
                          0.0);
                mean += glm::dot(tangent, along_u) / double(3 * mesh.triangles.size());
            }
        }
        EXPECT_GT(mean, 0.97) << to_string(kind);
    }
}

TEST(Tangents, MoveWithTheirPlacement) {
    const Vec3f up(0, 0, 1);
    const Mat3d turn(glm::rotate(Mat4d(1.0), 0.5, Vec3d(0, 0, 1)));
    const Vec4f turned = placed_tangent({1, 0, 0, 1}, up, turn);
    EXPECT_NEAR(turned.x, std::cos(0.5), 1e-6);
    EXPECT_NEAR(turned.y, std::sin(0.5), 1e-6);
    EXPECT_EQ(turned.w, 1.0f);
    EXPECT_EQ(placed_tangent({1, 0, 0, 1}, up, Mat3d(-1, 0, 0, 0, 1, 0, 0, 0, 1)),
              Vec4f(-1, 0, 0, -1));
    const Vec4f any = placed_tangent({1, 0, 0, -1}, up, Mat3d(0.0));
    EXPECT_NEAR(glm::length(Vec3d(any)), 1.0, 1e-6);
    EXPECT_EQ(any.z, 0.0f);
}

}  // namespace
}  // namespace burl
