// Shared vertices against a map of all corners in order.
#include "app/export/vertices.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

#include "atlas/mesh/connectivity.h"
#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

/// A hub of many triangles beside a sphere in two parts; normals and w of few values, so that
/// corners agree and differ at every point.
struct Sample {
    Mesh mesh = sphere_mesh(10, 20);
    Atlas atlas;
    std::vector<Vec3f> normals;
    std::vector<Vec4f> tangents;

    Sample() {
        const auto hub = std::uint32_t(mesh.positions.size());
        mesh.positions.push_back({0, 0, 3});
        for (std::uint32_t i = 0; i < 200; ++i) {
            mesh.positions.push_back({std::cos(0.03 * i), std::sin(0.03 * i), 3});
            if (i > 0) mesh.triangles.push_back({hub, hub + i, hub + i + 1});
        }
        const auto triangles = std::uint32_t(mesh.triangles.size());
        mesh.parts = {{"a", 0, 33, {Mat4d(1.0)}},
                      {"none", 33, 0, {Mat4d(1.0)}},
                      {"b", 33, triangles - 33, {Mat4d(1.0)}}};
        atlas = pair_atlas(mesh, 64);
        std::mt19937 random(5);
        for (std::size_t c = 0; c < 3 * mesh.triangles.size(); ++c) {
            // Few places in the texture, so that agreement is left to normals and w.
            atlas.corners[c / 3][c % 3] = {double(random() % 2), 0.0};
            normals.push_back(random() % 2 ? Vec3f(0, 0, 1)
                                           : Vec3f(random() % 2 ? -0.0f : 0.0f, 1, 0));
            tangents.emplace_back(1, 0, 0, random() % 2 ? 1 : -1);
        }
    }
};

void expect_shared(const Sample& sample, std::span<const Vec4f> tangents) {
    const auto parts = export_vertices(sample.mesh, sample.atlas, sample.normals, tangents);
    ASSERT_EQ(parts.size(), 2u);
    for (const PartVertices& got : parts) {
        const Part& part = sample.mesh.parts[got.part];
        std::map<std::tuple<std::uint32_t, double, float, float, float>, std::uint32_t> known;
        std::vector<std::uint32_t> indices;
        for (std::size_t c = 3 * part.first_triangle; indices.size() < 3 * part.triangle_count;
             ++c) {
            const Vec3f& n = sample.normals[c];
            const float w = tangents.empty() ? 0.0f : tangents[c].w;
            const auto point = sample.mesh.triangles[c / 3][c % 3];
            const double u = sample.atlas.corners[c / 3][c % 3].x;
            const auto [entry, is_new] = known.try_emplace({point, u, n.y, n.z, w}, known.size());
            indices.push_back(entry->second);
            if (!is_new) continue;
            const std::size_t i = entry->second;
            ASSERT_LT(i, got.positions.size());
            EXPECT_EQ(got.normals[i], n);
            EXPECT_EQ(double(got.uvs[i][0]), u / 64.0);
            EXPECT_EQ(tangents.empty() ? 0.0f : got.tangents[i].w, w);
            const Vec3d place = got.centre + got.scale * Vec3d(got.positions[i]);
            EXPECT_LT(glm::distance(place, sample.mesh.positions[point]), 1e-6);
        }
        EXPECT_EQ(got.indices, indices);
        EXPECT_EQ(got.positions.size(), known.size());
        EXPECT_EQ(got.normals.size(), known.size());
        EXPECT_EQ(got.uvs.size(), known.size());
        EXPECT_EQ(got.tangents.size(), tangents.empty() ? 0 : known.size());
    }
}

/// In blocks as they are laid out, corners agree where they agree in all that a map of all corners
/// looks at, though every block is worked at apart.
TEST(ExportVertices, OfBlocksAreThoseOfAMapOfAllCorners) {
    Sample sample;
    for (const auto& [overscan, size] : {std::pair{Overscan::bilinear, 256u},
                                         {Overscan::nearest, 256u},
                                         {Overscan::bilinear, 8u}}) {
        AtlasOptions options{AtlasKind::quad, overscan, size};
        sample.atlas = layout_atlas(sample.mesh, build_connectivity(sample.mesh), options);
        const auto parts = export_vertices(sample.mesh, sample.atlas, sample.normals);
        for (const PartVertices& got : parts) {
            const Part& part = sample.mesh.parts[got.part];
            std::map<std::tuple<std::uint32_t, float, float, float>, std::uint32_t> known;
            std::vector<std::uint32_t> indices;
            for (std::size_t c = 3 * part.first_triangle; indices.size() < 3 * part.triangle_count;
                 ++c) {
                const Vec2d uv = sample.atlas.corners[c / 3][c % 3] / double(size);
                const auto point = sample.mesh.triangles[c / 3][c % 3];
                indices.push_back(
                    known.try_emplace({point, uv.x, uv.y, sample.normals[c].z}, known.size())
                        .first->second);
            }
            EXPECT_EQ(got.indices, indices) << to_string(overscan) << " " << size;
            EXPECT_LT(got.positions.size(), indices.size());
        }
    }
}

TEST(ExportVertices, AreSharedByCornersThatAgreeAndNumberedInTheirOrder) {
    const Sample sample;
    expect_shared(sample, {});
    expect_shared(sample, sample.tangents);
}

}  // namespace
}  // namespace burl
