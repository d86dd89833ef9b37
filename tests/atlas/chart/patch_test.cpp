// Patches of shapes whose topology is known, and what cutting must and must not change.
#include "atlas/chart/patch.h"

#include <gtest/gtest.h>

#include "atlas/patch/cut.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

TEST(Patch, KnownTopologies) {
    const auto topology = [](const Mesh& mesh) {
        const Patch patch = made::whole(mesh);
        made::expect_sound(patch);
        return topology_of(patch);
    };
    const PatchTopology sheet = topology(made::grid(5, 4));
    EXPECT_TRUE(sheet.is_disk());
    EXPECT_EQ(sheet.euler_characteristic, 1);
    const PatchTopology ball = topology(made::ball(2));
    EXPECT_EQ(ball.euler_characteristic, 2);
    EXPECT_EQ(ball.loops + ball.handles, 0u);
    const PatchTopology tube = topology(made::tube(8, 3, 2.0));
    EXPECT_EQ(tube.loops, 2u);
    EXPECT_EQ(tube.handles, 0u);
    const PatchTopology ring = topology(made::ring(9, 7));
    EXPECT_EQ(ring.loops, 0u);
    EXPECT_EQ(ring.handles, 1u);
    EXPECT_FALSE(ring.is_disk());
    const PatchTopology soup = topology(made::soup(5, 2));
    EXPECT_EQ(soup.components, 5u);
    EXPECT_EQ(soup.loops, 5u);
}

TEST(Patch, CornersThatOnlyTouchArePartedIntoVertices) {
    const Mesh mesh = made::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                                    {{0, 1, 2}, {0, 3, 4}});
    const Patch patch = made::whole(mesh);
    EXPECT_EQ(patch.points.size(), 6u);
    EXPECT_EQ(patch.loops.size(), 2u);
    EXPECT_EQ(component_faces(patch), (std::vector<std::vector<std::uint32_t>>{{0}, {1}}));
}

TEST(Patch, TakesOnlyTheFacesAskedForInTheirOrder) {
    const Mesh mesh = made::grid(4, 4);
    const Patch patch = made::patch_of(mesh, {9, 8, 10});
    EXPECT_EQ(patch.faces, (std::vector<std::uint32_t>{9, 8, 10}));
    made::expect_sound(patch);
    double area = 0.0;
    for (const std::size_t face : {8u, 9u, 10u}) area += triangle_area(mesh, face);
    EXPECT_NEAR(area_of(patch), area, 1e-15);
    for (std::size_t v = 0; v < patch.points.size(); ++v)
        EXPECT_EQ(patch.points[v], mesh.positions[patch.origins[v].a]);
}

TEST(Patch, LongestLoopComesFirst) {
    Mesh mesh = made::tube(8, 3, 2.0);
    for (Vec3d& p : mesh.positions) p *= Vec3d(1.0 + p.z, 1.0 + p.z, 1.0);
    const Patch patch = made::whole(mesh);
    ASSERT_EQ(patch.loops.size(), 2u);
    EXPECT_GT(length_of(patch, patch.loops[0]), 2.9 * length_of(patch, patch.loops[1]));
}

TEST(PatchCut, TubeBecomesADiskAlongAStraightCut) {
    const Mesh mesh = made::tube(12, 6, 3.0);
    Patch patch = made::whole(mesh);
    const double area = area_of(patch),
                 border = length_of(patch, patch.loops[0]) + length_of(patch, patch.loops[1]);
    EXPECT_EQ(slit_tube(patch), 1u);
    made::expect_sound(patch);
    EXPECT_TRUE(topology_of(patch).is_disk());
    EXPECT_NEAR(area_of(patch), area, 1e-12);
    // The shortest cut follows the axis: both its sides join the border, with doubled vertices.
    EXPECT_NEAR(length_of(patch, patch.loops[0]), border + 2 * 3.0, 1e-12);
    EXPECT_EQ(patch.points.size(), mesh.positions.size() + 7);
}

TEST(PatchCut, SockIsCutToItsTip) {
    const Mesh ball = made::ball(3);
    std::vector<std::uint32_t> upper;
    for (std::uint32_t t = 0; t < ball.triangles.size(); ++t) {
        double height = 0.0;
        for (const std::uint32_t p : ball.triangles[t]) height += ball.positions[p].z;
        if (height > 0.0) upper.push_back(t);
    }
    Patch patch = made::patch_of(ball, upper);
    ASSERT_TRUE(topology_of(patch).is_disk());
    const std::size_t border = patch.loops[0].size();
    ASSERT_TRUE(slit_sock(patch));
    made::expect_sound(patch);
    EXPECT_TRUE(topology_of(patch).is_disk());
    bool pole = false;
    for (const HalfEdge h : patch.loops[0])
        pole |= glm::length(patch.points[patch.start(h)] - Vec3d(0, 0, 1)) < 1e-12;
    EXPECT_TRUE(pole);
    EXPECT_EQ(patch.loops[0].size(), border + 2 * 8);  // eight edges from equator to pole
}

TEST(PatchCut, NothingToSlit) {
    Patch square = made::whole(made::square());
    const Patch before = square;
    EXPECT_FALSE(slit_sock(square));
    EXPECT_EQ(slit_tube(square), 0u);
    EXPECT_EQ(square.neighbours, before.neighbours);
    Patch closed = made::whole(made::ball(1));
    EXPECT_FALSE(slit_sock(closed));
}

TEST(PatchCut, HolesOfTheMeshAreClosedAndOthersLeft) {
    const Mesh sheet = made::grid(10, 10);
    std::vector<Triangle> pierced;
    for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t)
        if (t != 90 && t != 91) pierced.push_back(sheet.triangles[t]);
    const Mesh mesh = made::mesh_of(sheet.positions, pierced);
    Patch patch = made::whole(mesh);
    ASSERT_EQ(patch.loops.size(), 2u);
    const double area = area_of(patch);
    EXPECT_EQ(fan_holes(patch, build_connectivity(mesh)), 1u);
    made::expect_sound(patch);
    EXPECT_TRUE(topology_of(patch).is_disk());
    EXPECT_EQ(patch.triangles.size(), pierced.size() + 4);
    EXPECT_EQ(std::count(patch.faces.begin(), patch.faces.end(), not_in_mesh), 4);
    EXPECT_EQ(patch.origins.back(), VertexOrigin{});
    EXPECT_NEAR(area_of(patch), area, 1e-15);
    // The same outline, where the mesh itself goes on.
    std::vector<std::uint32_t> faces;
    for (std::uint32_t t = 0; t < sheet.triangles.size(); ++t)
        if (t != 90 && t != 91) faces.push_back(t);
    Patch open = made::patch_of(sheet, faces);
    EXPECT_EQ(fan_holes(open, build_connectivity(sheet)), 0u);
    EXPECT_EQ(open.loops.size(), 2u);
    // And a hole as long as the outline itself stays a tube's end.
    const Mesh ends = made::tube(12, 3, 2.0);
    Patch tube = made::whole(ends);
    EXPECT_EQ(fan_holes(tube, build_connectivity(ends)), 0u);
}

}  // namespace
}  // namespace burl
