// Welding, numbering, counting and the carrying of attributes, on soups made by hand.
#include "atlas/mesh/mesh_builder.h"

#include <random>

#include "atlas/read/readers.h"
#include "tests/atlas/support/mesh_files.h"

namespace burl {
namespace {

using test::read_text;

PolygonSoup soup_of(std::vector<Vec3d> points, std::vector<std::uint32_t> corners) {
    PolygonSoup soup;
    soup.points = std::move(points);
    soup.corners = std::move(corners);
    return soup;
}

TEST(MeshBuilder, NumbersPointsByFirstUse) {
    const Mesh mesh = build_mesh(
        soup_of({{9, 9, 9}, {0, 1, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, -0.0}}, {3, 2, 1, 1, 4, 3}),
        "x.obj");
    EXPECT_EQ(mesh.positions, (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 1, 0}}));
    EXPECT_EQ(mesh.notes.unreferenced_points, 1u);
    EXPECT_EQ(mesh.notes.merged_points, 1u);
    EXPECT_EQ(mesh.notes.duplicate_triangles, 1u);
}

TEST(MeshBuilder, BitwiseWeldingKeepsNeighbours) {
    const double next = std::nextafter(1.0, 2.0);
    const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {next, 0, 0}};
    EXPECT_EQ(build_mesh(soup_of(points, {0, 1, 2, 0, 3, 2}), "x").positions.size(), 4u);
    EXPECT_EQ(build_mesh(soup_of(points, {0, 1, 2, 0, 3, 2}), "x", {.weld = 1e-9}).positions.size(),
              3u);
}

TEST(MeshBuilder, TolerantWeldingAgreesWithBruteForce) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    PolygonSoup soup;
    for (std::uint32_t i = 0; i < 900; ++i) {
        soup.points.push_back({uniform(random), uniform(random), 0.2 * uniform(random)});
        soup.corners.push_back(i);
    }
    const std::vector<Vec3d> points = soup.points;
    const double weld = 0.03;
    Box3 box{points[0], points[0]};
    for (const Vec3d& p : points) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    std::vector<Vec3d> kept;
    std::vector<std::uint32_t> ids;
    for (const Vec3d& p : points) {
        std::uint32_t id = 0;
        while (id < kept.size() && glm::distance(kept[id], p) > weld * box.longest_side()) ++id;
        if (id == kept.size()) kept.push_back(p);
        ids.push_back(id);
    }
    const Mesh mesh = build_mesh(std::move(soup), "x", {.weld = weld});
    EXPECT_EQ(mesh.positions, kept);
    EXPECT_LT(kept.size(), 800u);  // the case is not trivial
    for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(mesh.triangles[i / 3][i % 3], ids[i]);
}

TEST(MeshBuilder, WeldIsRelativeToTheBox) {
    for (const double scale : {1e-30, 1.0, 1e30}) {
        std::vector<Vec3d> points{{0, 0, 0},     {4, 0, 0}, {0, 4, 0},
                                  {4.001, 0, 0}, {4, 4, 0}, {0, 4.001, 0}};
        for (Vec3d& p : points) p *= scale;
        const Mesh mesh = build_mesh(soup_of(points, {0, 1, 2, 3, 4, 5}), "x", {.weld = 1e-3});
        EXPECT_EQ(mesh.positions.size(), 4u);
        EXPECT_EQ(mesh.notes.merged_points, 2u);
    }
}

TEST(MeshBuilder, CountsDegenerateTrianglesAtAnyScale) {
    for (const double scale : {1e-30, 1.0, 1e30}) {
        std::vector<Vec3d> points{{0, 0, 0},     {1, 0, 0},    {0, 1, 0},
                                  {0.5, 0.5, 0}, {1e-6, 0, 0}, {0, 1e-6, 0}};
        for (Vec3d& p : points) p *= scale;
        const Mesh mesh = build_mesh(soup_of(points, {0, 1, 2, 1, 1, 2, 1, 3, 2, 0, 4, 5}),
                                     "x");  // fine, repeated, line, small
        EXPECT_EQ(mesh.notes.degenerate_triangles, 2u) << scale;
        EXPECT_EQ(mesh.triangles.size(), 4u);
    }
    EXPECT_EQ(build_mesh(soup_of({{1, 1, 1}}, {0, 0, 0}), "x").notes.degenerate_triangles, 1u);
}

TEST(MeshBuilder, ConcavePolygonsKeepTheirAreaAndAttributes) {
    // An L of area 3 with a uv per corner equal to its position: both must give the same area.
    const Mesh mesh = read_text("a.obj",
                                "v 0 0 7\nv 2 0 7\nv 2 1 7\nv 1 1 7\nv 1 2 7\nv 0 2 7\n"
                                "vt 0 0\nvt 2 0\nvt 2 1\nvt 1 1\nvt 1 2\nvt 0 2\n"
                                "f 4/4 5/5 6/6 1/1 2/2 3/3\n");
    ASSERT_EQ(mesh.triangles.size(), 4u);
    EXPECT_DOUBLE_EQ(test::total_area(mesh), 3.0);
    for (std::size_t i = 0; i < 12; ++i) {
        const Vec3d p = test::corner(mesh, i / 3, i % 3);
        EXPECT_EQ(mesh.corners.uvs[i], Vec2d(p.x, 1.0 - p.y));
    }
}

TEST(MeshBuilder, WeldingLeavesAttributesPerCorner) {
    const Mesh mesh = read_text("a.obj",
                                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nvn 0 0 1\nvn 1 0 0\n"
                                "f 1//1 2//1 3//1\nf 4//2 3//2 2//2\n");
    EXPECT_EQ(mesh.triangles[1][0], mesh.triangles[0][0]);
    EXPECT_EQ(mesh.corners.normals[0], Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.corners.normals[3], Vec3f(1, 0, 0));
}

TEST(MeshBuilder, AttributesThatAreNotFiniteAreReplaced) {
    PolygonSoup soup = soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    soup.normals.values = {{nan, 0, 1}, {0, 0, 2}, {0, 0, 0}};
    soup.colors.values = {{nan, 0.5f, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}};
    soup.uvs.values = {{0, 0}, {std::numeric_limits<double>::infinity(), 0.5}, {0, 0}};
    const Mesh mesh = build_mesh(std::move(soup), "x");
    for (const Vec3f& normal : mesh.corners.normals) EXPECT_EQ(normal, Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.corners.colors[0], Vec4f(1, 0.5f, 0, 1));
    EXPECT_EQ(mesh.corners.uvs[1], Vec2d(0, 0.5));
    EXPECT_EQ(mesh.notes.sentences.size(), 2u);
}

TEST(MeshBuilder, ParsingAndBuildingCanBeDoneApart) {
    const std::string path =
        test::write_file("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    PolygonSoup soup = parse_mesh(path);
    EXPECT_EQ(soup.face_count(), 1u);
    EXPECT_EQ(build_mesh(std::move(soup), path).triangles, read_mesh(path).triangles);
}

}  // namespace
}  // namespace burl
