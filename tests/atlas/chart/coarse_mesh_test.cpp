// Coarse meshes lie on the fine ones, keep their topology, and every fine triangle finds one near
// it.
#include "atlas/chart/coarse_mesh.h"

#include <gtest/gtest.h>

#include "atlas/chart/edge_collapse.h"
#include "atlas/patch/partition.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

double area_of(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += triangle_area(mesh, t);
    return sum;
}

CoarseMesh coarse(const Mesh& mesh, std::size_t most) {
    return coarsen(mesh, build_connectivity(mesh), most);
}

TEST(CoarseMesh, BallStaysABallAndNearIsNear) {
    const Mesh ball = made::ball(5);
    const CoarseMesh c = coarse(ball, 1500);
    EXPECT_LE(c.mesh.triangles.size(), 1500u);
    EXPECT_GT(c.mesh.triangles.size(), 1000u);
    EXPECT_NEAR(area_of(c.mesh) / area_of(ball), 1.0, 0.02);
    const Connectivity rebuilt = build_connectivity(c.mesh);
    EXPECT_EQ(rebuilt.neighbours, c.connectivity.neighbours);
    EXPECT_EQ(rebuilt.boundary_edges, 0u);
    EXPECT_EQ(rebuilt.split_faces, 0u);
    // Closed, and of the sphere's Euler characteristic.
    EXPECT_EQ(2 * c.mesh.positions.size(), c.mesh.triangles.size() + 4);
    const double edge = std::sqrt(area_of(ball) / 1500.0 * 4.0 / std::sqrt(3.0));
    ASSERT_EQ(c.nearest.size(), ball.triangles.size());
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
        const auto centre = [](const Mesh& mesh, std::size_t i) {
            const Triangle& v = mesh.triangles[i];
            return (mesh.positions[v[0]] + mesh.positions[v[1]] + mesh.positions[v[2]]) / 3.0;
        };
        EXPECT_LT(glm::distance(centre(ball, t), centre(c.mesh, c.nearest[t])), 2.0 * edge);
    }
}

TEST(CoarseMesh, CreasesAndBordersStay) {
    const Mesh box = made::box(12);
    const CoarseMesh c = coarse(box, 300);
    EXPECT_LT(c.mesh.triangles.size(), box.triangles.size() / 2);
    EXPECT_NEAR(area_of(c.mesh), area_of(box), 0.03 * area_of(box));
    Mesh sheet = made::grid(20, 20);
    for (Vec3d& p : sheet.positions) p.z = 0.0;
    const CoarseMesh flat = coarse(sheet, 200);
    EXPECT_LT(flat.mesh.triangles.size(), sheet.triangles.size() / 2);
    EXPECT_NEAR(area_of(flat.mesh), area_of(sheet), 1e-9);
    EXPECT_EQ(build_connectivity(flat.mesh).boundary_edges, 80u);
}

TEST(CoarseMesh, OddMeshesSurvive) {
    for (const auto& [name, mesh] : made::all()) {
        SCOPED_TRACE(name);
        const CoarseMesh c = coarse(mesh, 4);
        ASSERT_EQ(c.nearest.size(), mesh.triangles.size());
        for (const std::uint32_t t : c.nearest) EXPECT_LT(t, c.mesh.triangles.size());
        EXPECT_EQ(c.connectivity.neighbours.size(), c.mesh.triangles.size());
    }
}

TEST(EdgeCollapse, EveryCollapseNamesItsRing) {
    const Patch patch = made::whole(made::ball(3));
    const CollapsedMesh c = collapse_edges(patch.points, patch.triangles, 300);
    EXPECT_EQ(patch.triangles.size() - c.triangles.size(), 2 * c.collapses.size());
    std::vector<bool> gone(patch.points.size(), false);
    for (const Collapse& one : c.collapses) {
        ASSERT_GE(one.count, 3u);
        EXPECT_FALSE(gone[one.vertex]);
        for (std::uint32_t i = 0; i < one.count; ++i) EXPECT_FALSE(gone[c.ring[one.first + i]]);
        gone[one.vertex] = true;
    }
    for (const Triangle& t : c.triangles)
        for (const std::uint32_t v : t) EXPECT_FALSE(gone[v]);
    for (std::size_t t = 0; t < c.heir.size(); ++t) EXPECT_EQ(c.heir[c.heir[t]], c.heir[t]);
}

TEST(Partition, LabelsBecomeConnectedRegions) {
    const Mesh mesh = made::grid(10, 10);
    std::vector<std::uint32_t> labels(200, 0);
    for (std::size_t t = 100; t < 200; ++t) labels[t] = 7;
    labels[44] = labels[45] = 7;  // an island in the first half: given to it
    const Regions regions = regions_of_labels(mesh, build_connectivity(mesh), labels);
    ASSERT_EQ(regions.size(), 2u);
    for (std::uint32_t t = 0; t < 100; ++t) {
        EXPECT_EQ(regions[0][t], t);
        EXPECT_EQ(regions[1][t], t + 100);
    }
}

}  // namespace
}  // namespace burl
