// Connectivity against counts that follow from Euler's formula, and its promises on broken meshes.
#include "atlas/mesh/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace burl {
namespace {

Mesh mesh_of(std::uint32_t points, std::vector<Triangle> triangles) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < points; ++i) mesh.positions.emplace_back(i, i * i, i % 3);
    mesh.triangles = std::move(triangles);
    return mesh;
}

/// An n x m torus: closed, every edge with two faces.
Mesh torus(std::uint32_t n, std::uint32_t m) {
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < m; ++j) {
            const std::uint32_t a = i * m + j, b = (i + 1) % n * m + j;
            const std::uint32_t c = (i + 1) % n * m + (j + 1) % m, d = i * m + (j + 1) % m;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return mesh_of(n * m, triangles);
}

void expect_consistent(const Mesh& mesh, const Connectivity& connectivity) {
    ASSERT_EQ(connectivity.neighbours.size(), mesh.triangles.size());
    std::uint64_t sides = 0, open = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t other = connectivity.neighbours[t][k];
            ++(other < 0 ? open : sides);
            if (other < 0) continue;
            const auto u = static_cast<std::size_t>(other);
            ASSERT_LT(u, mesh.triangles.size());
            bool returned = false;
            for (std::size_t j = 0; j < 3; ++j)
                returned |= connectivity.neighbours[u][j] == static_cast<std::int32_t>(t) &&
                            mesh.triangles[u][j] == mesh.triangles[t][(k + 1) % 3] &&
                            mesh.triangles[u][(j + 1) % 3] == mesh.triangles[t][k];
            EXPECT_TRUE(returned) << "triangle " << t << " side " << k;
        }
    EXPECT_EQ(connectivity.interior_edges, sides / 2);
    EXPECT_GE(connectivity.boundary_edges, open > 0 ? 1u : 0u);
}

TEST(Connectivity, TorusIsClosed) {
    const Mesh mesh = torus(9, 7);
    const Connectivity c = build_connectivity(mesh);
    expect_consistent(mesh, c);
    EXPECT_EQ(c.interior_edges, 3u * 9 * 7);  // E = 3V on a triangulated torus
    EXPECT_EQ(c.boundary_edges, 0u);
    EXPECT_EQ(c.split_faces, 0u);
    EXPECT_EQ(c.shells, 1u);
}

TEST(Connectivity, FaceOrderDoesNotMatter) {
    Mesh mesh = torus(6, 5);
    const std::size_t n = mesh.triangles.size();
    std::vector<Triangle> shuffled(n);
    for (std::size_t t = 0; t < n; ++t) shuffled[t * 37 % n] = mesh.triangles[t];
    mesh.triangles = shuffled;
    const Connectivity c = build_connectivity(mesh);
    expect_consistent(mesh, c);
    EXPECT_EQ(c.interior_edges, 3u * 6 * 5);
    EXPECT_EQ(c.split_faces, 0u);
}

TEST(Connectivity, NeighboursOfASheet) {
    const Mesh mesh = mesh_of(4, {{0, 1, 2}, {2, 1, 3}});
    const Connectivity c = build_connectivity(mesh);
    EXPECT_EQ(c.neighbours[0], (std::array<std::int32_t, 3>{-1, 1, -1}));
    EXPECT_EQ(c.neighbours[1], (std::array<std::int32_t, 3>{0, -1, -1}));
    EXPECT_EQ(c.interior_edges, 1u);
    EXPECT_EQ(c.boundary_edges, 4u);
}

TEST(Connectivity, NonManifoldFacesAreKept) {
    const Mesh fan = mesh_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});  // three on one edge
    const Connectivity c = build_connectivity(fan);
    expect_consistent(fan, c);
    EXPECT_EQ(c.split_faces, 1u);
    EXPECT_EQ(c.neighbours[0][0], 1);
    EXPECT_EQ(c.neighbours[2], (std::array<std::int32_t, 3>{-1, -1, -1}));
    EXPECT_EQ(c.shells, 2u);

    const Mesh flipped = mesh_of(4, {{0, 1, 2}, {1, 2, 3}});  // wound against each other
    EXPECT_EQ(build_connectivity(flipped).split_faces, 1u);
    expect_consistent(flipped, build_connectivity(flipped));

    const Mesh bow_tie = mesh_of(5, {{0, 1, 2}, {0, 3, 4}});
    const Connectivity tie = build_connectivity(bow_tie);
    expect_consistent(bow_tie, tie);
    EXPECT_EQ(tie.shells, 2u);
    EXPECT_EQ(tie.boundary_edges, 6u);
}

TEST(Connectivity, ADuplicateSheetStaysASheet) {
    Mesh mesh = torus(5, 4);
    const auto copy = mesh.triangles;
    mesh.triangles.insert(mesh.triangles.end(), copy.begin(), copy.end());
    const Connectivity c = build_connectivity(mesh);
    expect_consistent(mesh, c);
    EXPECT_EQ(c.split_faces, copy.size());
    EXPECT_EQ(c.interior_edges, 2u * 3 * 5 * 4);
    EXPECT_EQ(c.shells, 2u);
}

TEST(Connectivity, DegenerateTrianglesHaveNoNeighbours) {
    const Mesh mesh = mesh_of(4, {{0, 1, 1}, {0, 1, 2}, {2, 2, 2}, {2, 1, 3}});
    const Connectivity c = build_connectivity(mesh);
    expect_consistent(mesh, c);
    EXPECT_EQ(c.neighbours[0], (std::array<std::int32_t, 3>{-1, -1, -1}));
    EXPECT_EQ(c.neighbours[1][1], 3);
    EXPECT_EQ(c.shells, 1u);
    EXPECT_EQ(c.boundary_edges, 4u);
}

TEST(Connectivity, AHubOfManyFaces) {
    const std::uint32_t n = 20000;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < n; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
    const Mesh mesh = mesh_of(n + 1, triangles);
    const Connectivity c = build_connectivity(mesh);
    expect_consistent(mesh, c);
    EXPECT_GE(c.interior_edges, n - 6);  // the hub is split into a few vertices
}

TEST(Connectivity, SilentAndEmpty) {
    testing::internal::CaptureStderr();
    build_connectivity(mesh_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(build_connectivity({}).shells, 0u);
}

/// A tube of two rings is cut off a torus: two tubes with two borders each, of m edges.
TEST(Connectivity, CutBetweenLabels) {
    const std::uint32_t n = 5, m = 7;
    const Mesh mesh = torus(n, m);
    Connectivity connectivity = build_connectivity(mesh);
    std::vector<std::uint32_t> labels(mesh.triangles.size());
    for (std::size_t t = 0; t < labels.size(); ++t) labels[t] = t / (2 * m) < 2 ? 8 : 3;
    cut_between(connectivity, mesh, labels);
    EXPECT_EQ(connectivity.shells, 2u);
    EXPECT_EQ(connectivity.boundary_edges, 4 * m);
    EXPECT_EQ(connectivity.interior_edges, 3 * n * m - 2 * m);
    expect_consistent(mesh, connectivity);
    for (std::size_t t = 0; t < labels.size(); ++t)
        for (const std::int32_t side : connectivity.neighbours[t])
            EXPECT_TRUE(side < 0 || labels[std::size_t(side)] == labels[t]);
}

}  // namespace
}  // namespace burl
