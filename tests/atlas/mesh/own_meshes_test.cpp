// Each of our sample meshes has the properties it is there for: counted by brute force over edges,
// and measured against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/read/read_mesh.h"
#include "tests/paths.h"

namespace burl {
namespace {

constexpr double pi = std::numbers::pi;

Mesh made(const std::string& name) {
    return read_mesh(test::mesh_folder() + "/" + name);
}

Mesh nasty(const std::string& name) {
    return read_mesh(test::source_folder() + "/assets/meshes/nasty/" + name + ".obj");
}

/// Counts of a mesh, from its directed edges alone.
struct Counts {
    long points = 0, edges = 0, faces = 0;
    long shells = 0;     ///< components connected across edges
    long border = 0;     ///< edges with one face
    long crowded = 0;    ///< edges with more than two faces
    long misturned = 0;  ///< edges that two faces run along the same way
    long euler() const { return points - edges + faces; }
    bool closed_manifold() const { return border == 0 && crowded == 0 && misturned == 0; }
};

Counts count(const Mesh& mesh) {
    struct Use {
        int up = 0, down = 0;
        std::size_t face = 0;  ///< one that has the edge
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Use> uses;
    std::vector<std::size_t> parent(mesh.triangles.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::size_t face) {
        while (parent[face] != face) face = parent[face] = parent[parent[face]];
        return face;
    };
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& t = mesh.triangles[face];
            const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
            Use& use = uses.try_emplace({a, b}, Use{0, 0, face}).first->second;
            ++(t[k] == a ? use.up : use.down);
            parent[root(face)] = root(use.face);
        }
    Counts c;
    for (std::size_t face = 0; face < parent.size(); ++face) c.shells += parent[face] == face;
    c.points = static_cast<long>(mesh.positions.size());
    c.faces = static_cast<long>(mesh.triangles.size());
    c.edges = static_cast<long>(uses.size());
    for (const auto& [edge, use] : uses) {
        c.border += use.up + use.down == 1;
        c.crowded += use.up + use.down > 2;
        c.misturned += use.up + use.down == 2 && use.up != use.down;
    }
    return c;
}

double area(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += triangle_area(mesh, t);
    return sum;
}

double volume(const Mesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        sum += glm::dot(p[a], glm::cross(p[b], p[c])) / 6.0;
    }
    return sum;
}

/// Longest edge over the height on it.
double slenderness(const Mesh& mesh, std::size_t t) {
    const double edge = longest_edge(mesh, t);
    return edge * edge / (2.0 * triangle_area(mesh, t));
}

std::size_t slender_triangles(const Mesh& mesh, double at_least) {
    std::size_t number = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        number += slenderness(mesh, t) >= at_least;
    return number;
}

TEST(OwnMeshes, TeapotHasNewellsSizeAndShells) {
    const Mesh mesh = made("teapot.obj");
    EXPECT_EQ(mesh.triangles.size(), 6320u);
    const Box3 box = bounding_box(mesh);
    EXPECT_NEAR(glm::distance(box.low, Vec3d(-3.0, 0.0, -2.0)), 0.0, 1e-6);
    EXPECT_NEAR(glm::distance(box.high, Vec3d(3.434, 3.15, 2.0)), 0.0, 1e-6);

    // Pot and lid end in one open circle each, of 4 x 10 edges; handle and spout in two of 2 x 10.
    const Counts counts = count(mesh);
    EXPECT_EQ(counts.border, 40 + 40 + 2 * 20 + 2 * 20);
    EXPECT_EQ(counts.crowded, 0);
    EXPECT_EQ(counts.misturned, 0);
    EXPECT_EQ(count(mesh).shells, 4);
    EXPECT_EQ(mesh.notes.degenerate_triangles, 0u);
}

TEST(OwnMeshes, TeapotFacesOutwards) {
    const Mesh mesh = made("teapot.obj");
    // Below the rim the pot looks away from the axis; handle and spout (below its lip) away from
    // the plane of symmetry.
    std::size_t pot_faces = 0, tube_faces = 0, inwards = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        const Vec3d normal = glm::cross(p[b] - p[a], p[c] - p[a]);
        const Vec3d middle = (p[a] + p[b] + p[c]) / 3.0;
        const bool pot = middle.y > 0.2 && middle.y < 2.3 && std::abs(middle.x) < 1.4;
        const bool tube = std::abs(middle.x) > 2.1 && middle.y < 2.2;
        pot_faces += pot;
        tube_faces += tube;
        if (pot) inwards += normal.x * middle.x + normal.z * middle.z < 0.0;
        if (tube) inwards += normal.z * middle.z < 0.0;
    }
    EXPECT_GT(pot_faces, 500u);
    EXPECT_GT(tube_faces, 500u);
    EXPECT_EQ(inwards, 0u);
}

TEST(OwnMeshes, KingIsTwoClosedShellsWithSlivers) {
    const Mesh mesh = made("king.obj");
    EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), 2750.0, 50.0);
    EXPECT_TRUE(count(mesh).closed_manifold());
    EXPECT_EQ(count(mesh).euler(), 2 + 2);
    EXPECT_EQ(count(mesh).shells, 2);
    EXPECT_GT(volume(mesh), 0.0);
    // The stem is a band of 2 x 48; the arms of the cross have bevels on four long sides, twice.
    EXPECT_GE(slender_triangles(mesh, 25.0), 96u + 16u);
    EXPECT_DOUBLE_EQ(bounding_box(mesh).high.y, 9.0);
}

TEST(OwnMeshes, TorusHasGenusOneAndItsArea) {
    const Mesh mesh = made("torus.obj");
    EXPECT_TRUE(count(mesh).closed_manifold());
    EXPECT_EQ(count(mesh).euler(), 0);
    // A mesh inscribed with steps of 2 pi/64 and 2 pi/32 lies below by O(step^2).
    const double exact_area = 4.0 * pi * pi * 1.0 * 0.4;
    const double exact_volume = 2.0 * pi * pi * 1.0 * 0.4 * 0.4;
    EXPECT_LT(area(mesh), exact_area);
    EXPECT_GT(area(mesh), 0.995 * exact_area);
    EXPECT_LT(volume(mesh), exact_volume);
    EXPECT_GT(volume(mesh), 0.99 * exact_volume);
}

TEST(OwnMeshes, IcosphereIsNearlyASphere) {
    const Mesh mesh = made("icosphere.obj");
    EXPECT_EQ(mesh.triangles.size(), 20u * 256u);
    EXPECT_TRUE(count(mesh).closed_manifold());
    EXPECT_EQ(count(mesh).euler(), 2);
    for (const Vec3d& p : mesh.positions) ASSERT_NEAR(glm::length(p), 1.0, 1e-7);
    EXPECT_LT(area(mesh), 4.0 * pi);
    EXPECT_GT(area(mesh), 0.998 * 4.0 * pi);
    EXPECT_GT(volume(mesh), 0.995 * 4.0 / 3.0 * pi);
    EXPECT_EQ(slender_triangles(mesh, 1.5), 0u);
}

TEST(OwnMeshes, BustIsOneShellAndTheSameOnBothSides) {
    const Mesh mesh = made("bust.obj");
    EXPECT_TRUE(count(mesh).closed_manifold());
    EXPECT_EQ(count(mesh).euler(), 2);
    EXPECT_GT(volume(mesh), 0.0);
    EXPECT_LT(double(slender_triangles(mesh, 10.0)), 0.01 * double(mesh.triangles.size()));
    const Box3 box = bounding_box(mesh);
    EXPECT_NEAR(box.low.x, -box.high.x, 0.01);
    EXPECT_NEAR(box.low.y, 0.0, 0.02);  // smooth minima bulge
}

double polygon_area(int corners, double radius) {
    return 0.5 * corners * radius * radius * std::sin(2.0 * pi / corners);
}

TEST(OwnMeshes, CadPartHasTwoBoresFlatFacesAndSlivers) {
    const Mesh mesh = made("cad_part.obj");
    EXPECT_TRUE(count(mesh).closed_manifold());
    EXPECT_EQ(count(mesh).euler(), 2 - 2 * 2);
    EXPECT_GE(slender_triangles(mesh, 50.0), 8u);

    // The flat top: a rectangle of 3.8 x 1.8 whose corners are 12 chords of a quarter circle of
    // radius 0.3, less the bores' polygons. Overlapping or folded triangles would add to it.
    double top = 0.0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const auto& p = mesh.positions;
        if (p[a].y == 0.25 && p[b].y == 0.25 && p[c].y == 0.25) {
            top += triangle_area(mesh, t);
            EXPECT_GT(glm::cross(p[b] - p[a], p[c] - p[a]).y, 0.0) << "triangle " << t;
        }
    }
    const double corners = 4.0 * 0.3 * 0.3 - polygon_area(48, 0.3);
    EXPECT_NEAR(top, 3.8 * 1.8 - corners - polygon_area(48, 0.55) - polygon_area(32, 0.3), 1e-5);
}

TEST(OwnMeshes, EveryFormatCarriesTheSameTorus) {
    const Mesh obj = made("torus.obj");
    for (const char* name : {"torus.off", "torus_ascii.ply", "torus_little.ply", "torus_big.ply",
                             "torus_ascii.stl", "torus.stl", "torus.glb"}) {
        const Mesh other = made(name);
        EXPECT_EQ(other.positions, obj.positions) << name;
        EXPECT_EQ(other.triangles, obj.triangles) << name;
    }
}

TEST(NastyMeshes, NonManifoldEdgeHasThreeFaces) {
    const Counts counts = count(nasty("non_manifold_edge"));
    EXPECT_EQ(counts.faces, 3);
    EXPECT_EQ(counts.crowded, 1);
    EXPECT_EQ(counts.border, 6);
}

TEST(NastyMeshes, BowTieSharesOneVertexAndNoEdge) {
    const Mesh mesh = nasty("bow_tie");
    EXPECT_TRUE(count(mesh).closed_manifold());
    EXPECT_EQ(count(mesh).points, 7);
    EXPECT_EQ(count(mesh).shells, 2);
    // Two spheres that share a point: 2 + 2 - 1.
    EXPECT_EQ(count(mesh).euler(), 3);
    EXPECT_GT(volume(mesh), 0.0);
}

TEST(NastyMeshes, DuplicateFaces) {
    const Mesh mesh = nasty("duplicate_faces");
    EXPECT_EQ(mesh.triangles.size(), 7u);
    EXPECT_EQ(mesh.notes.duplicate_triangles, 3u);
    EXPECT_EQ(count(mesh).crowded, 3);
}

TEST(NastyMeshes, ZeroAreaFacesAreAllThere) {
    const Mesh mesh = nasty("zero_area");
    EXPECT_EQ(mesh.triangles.size(), 8u);
    EXPECT_EQ(mesh.notes.degenerate_triangles, 6u);
    EXPECT_DOUBLE_EQ(area(mesh), 1.0);
}

TEST(NastyMeshes, UnreferencedPointsAreCountedAndLeftOut) {
    const Mesh mesh = nasty("unreferenced");
    EXPECT_EQ(mesh.notes.unreferenced_points, 4u);
    EXPECT_EQ(mesh.positions.size(), 3u);
    EXPECT_EQ(bounding_box(mesh).high, Vec3d(1.0, 1.0, 0.0));
}

TEST(NastyMeshes, OneTriangle) {
    const Mesh mesh = nasty("one_triangle");
    EXPECT_EQ(mesh.triangles.size(), 1u);
    EXPECT_DOUBLE_EQ(area(mesh), 0.5);
}

TEST(NastyMeshes, TwoShells) {
    const Mesh mesh = nasty("two_shells");
    EXPECT_TRUE(count(mesh).closed_manifold());
    EXPECT_EQ(count(mesh).euler(), 2 + 2);
    EXPECT_EQ(count(mesh).shells, 2);
}

TEST(NastyMeshes, OpenSheetHasABorder) {
    const Counts counts = count(nasty("open_sheet"));
    EXPECT_EQ(counts.border, 8);
    EXPECT_EQ(counts.misturned, 0);
    EXPECT_EQ(counts.euler(), 1);
}

TEST(NastyMeshes, PolygonsCoverTheirAreas) {
    const Mesh mesh = nasty("polygons");
    EXPECT_EQ(mesh.notes.polygons, 5u);
    ASSERT_EQ(mesh.triangles.size(), 2u + 2u + 4u + 10u + 2u);
    std::array<double, 4> areas{};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (mesh.source_faces[t] < 4)
            areas[mesh.source_faces[t]] += triangle_area(mesh, t) / std::sqrt(3.0);
    // A fan that folds would cover more than the polygon.
    constexpr std::array<double, 4> expected{1.0, 1.0, 3.0, 8.0};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(areas[i], expected[i], 1e-12) << "polygon " << i;
}

TEST(NastyMeshes, FarAwayAndTinyAreCubes) {
    for (const auto& [name, edge] : {std::pair{"far_away", 1.0}, std::pair{"tiny", 1e-6}}) {
        const Mesh mesh = nasty(name);
        EXPECT_TRUE(count(mesh).closed_manifold()) << name;
        EXPECT_EQ(count(mesh).euler(), 2) << name;
        EXPECT_DOUBLE_EQ(area(mesh), 6.0 * edge * edge) << name;
        EXPECT_EQ(mesh.notes.degenerate_triangles, 0u) << name;
    }
    EXPECT_EQ(bounding_box(nasty("far_away")).centre(), Vec3d(1000000.5, -999999.5, 1000001.0));
}

TEST(NastyMeshes, FlippedNeighbour) {
    const Counts counts = count(nasty("flipped_neighbour"));
    EXPECT_EQ(counts.faces, 4);
    EXPECT_EQ(counts.misturned, 2);
    EXPECT_EQ(counts.crowded, 0);
}

}  // namespace
}  // namespace burl
