// Midpoint subdivision: the surface stays what it was.
#include "atlas/mesh/subdivide.h"

#include <cmath>

#include <gtest/gtest.h>

#include "atlas/base/error.h"
#include "atlas/mesh/connectivity.h"
#include "tests/atlas/support/made_shapes.h"

namespace burl {
namespace {

double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) area += triangle_area(mesh, t);
    return area;
}

/// A tetrahedron with attributes that are linear in the position.
Mesh tetrahedron() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}, {0, 0, 8}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    mesh.source_faces = {0, 1, 1, 2};
    mesh.parts = {{"a", 0, 1}, {"b", 1, 3}};
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t p : t) {
            const Vec3d at = mesh.positions[p];
            mesh.corners.uvs.emplace_back(at.x + 1, at.y - at.z);
            mesh.corners.colors.emplace_back(at.x, at.y, at.z, 1.0);
            mesh.corners.normals.emplace_back(0, 0, 1);
            mesh.corners.joints.push_back({std::uint16_t(p), 9, 0, 0});
            mesh.corners.weights.emplace_back(0.75f, 0.25f, 0.0f, 0.0f);
        }
    return mesh;
}

TEST(Subdivide, SplitsEveryTriangleInFourOfTheSameSurface) {
    const Mesh coarse = tetrahedron();
    for (const int times : {0, 1, 3}) {
        const Mesh fine = subdivided(coarse, times);
        const std::size_t factor = std::size_t(1) << (2 * times);
        EXPECT_EQ(fine.triangles.size(), 4 * factor);
        // Euler: V - E + F = 2 with E = 3F / 2, so nothing is torn.
        EXPECT_EQ(fine.positions.size(), 2 + fine.triangles.size() / 2);
        EXPECT_EQ(build_connectivity(fine).boundary_edges, 0u);
        EXPECT_NEAR(area_of(fine), area_of(coarse), 1e-12);
        EXPECT_EQ(fine.parts[1].first_triangle, factor);
        EXPECT_EQ(fine.parts[1].triangle_count, 3 * factor);
        ASSERT_EQ(fine.source_faces.size(), fine.triangles.size());
        EXPECT_EQ(fine.source_faces[3 * factor - 1], 1u);
        for (std::size_t t = 0; t < fine.triangles.size(); ++t)
            EXPECT_NEAR(triangle_area(fine, t), triangle_area(coarse, t / factor) / double(factor),
                        1e-12);
    }
}

TEST(Subdivide, AttributesStayLinearAndSkinsAddUpToOne) {
    const Mesh fine = subdivided(tetrahedron(), 2);
    std::uint32_t next = 0;
    for (std::size_t t = 0; t < fine.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t point = fine.triangles[t][k];
            const Vec3d at = fine.positions[point];
            const std::size_t corner = 3 * t + k;
            EXPECT_EQ(fine.corners.uvs[corner], Vec2d(at.x + 1, at.y - at.z));
            EXPECT_EQ(fine.corners.colors[corner], Vec4f(at.x, at.y, at.z, 1.0));
            EXPECT_EQ(fine.corners.normals[corner], Vec3f(0, 0, 1));
            const Vec4f w = fine.corners.weights[corner];
            EXPECT_NEAR(w.x + w.y + w.z + w.w, 1.0f, 1e-6f);
            // The joint that all corners share keeps its quarter wherever four joints suffice.
            for (int i = 0; i < 4; ++i) {
                if (fine.corners.joints[corner][std::size_t(i)] != 9 || w[i] == 0.0f) continue;
                EXPECT_NEAR(w[i], 0.25f, 1e-6f);
            }
            EXPECT_LE(point, next);  // points are numbered by their first use
            next = std::max(next, point + 1);
        }
    EXPECT_EQ(next, fine.positions.size());
}

TEST(Subdivide, RefusesMoreTrianglesThanAnybodyHasMemoryFor) {
    EXPECT_THROW(subdivided(tetrahedron(), 13), Error);
}

}  // namespace
}  // namespace burl
