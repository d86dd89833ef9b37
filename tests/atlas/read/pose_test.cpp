// Poses of meshes against places that formulas give.
#include "atlas/read/pose.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "atlas/build/mesh_atlas.h"
#include "atlas/read/read_mesh.h"
#include "tests/atlas/support/gltf_files.h"

namespace burl {
namespace {

using test::expect_error;
using test::GltfFile;

/// A wavy strip of quads along x, bent about z by `bend` radians.
Vec3d strip_point(int column, int row, double bend) {
    const double x = 0.25 * column, y = 0.3 * std::sin(1.7 * column), z = 0.5 * row;
    return {x * std::cos(bend * x) - y * std::sin(bend * x),
            x * std::sin(bend * x) + y * std::cos(bend * x), z};
}

/// The text of an .obj: a bent strip of quads, in columns of two points.
std::string strip_obj(double bend, int columns = 12) {
    std::string text;
    for (int c = 0; c <= columns; ++c)
        for (int r = 0; r < 2; ++r) {
            const Vec3d p = strip_point(c, r, bend);
            text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
        }
    for (int c = 0; c < columns; ++c)
        text += fmt::format("f {} {} {} {}\n", 2 * c + 1, 2 * c + 3, 2 * c + 4, 2 * c + 2);
    return text;
}

FileBuffer obj(const std::string& text, const char* name = "m.obj") {
    return buffer_from(text, name);
}

MeshPose pose_of(const std::string& rest, const std::string& posed) {
    return read_pose(obj(rest), obj(posed, "posed.obj"));
}

TEST(MeshPose, CornersOfASecondFileAreWhereItsFormulaPutsThem) {
    const Mesh mesh = test::read_text("m.obj", strip_obj(0.0));
    const MeshPose pose = pose_of(strip_obj(0.0), strip_obj(0.8));
    ASSERT_EQ(pose.positions.size(), 3 * mesh.triangles.size());
    EXPECT_EQ(pose.name, "posed");
    for (std::size_t c = 0; c < pose.positions.size(); ++c) {
        // Where the corner lies at rest says which of the strip's points it is.
        const Vec3d rest = mesh.positions[mesh.triangles[c / 3][c % 3]];
        const int column = int(std::lround(4 * rest.x)), row = int(std::lround(2 * rest.z));
        EXPECT_EQ(pose.positions[c], strip_point(column, row, 0.8)) << c;
    }
}

TEST(MeshPose, ThePosedMeshGoesInStraightLines) {
    const Mesh mesh = test::read_text("m.obj", strip_obj(0.0));
    const MeshPose pose = pose_of(strip_obj(0.0), strip_obj(0.8));
    EXPECT_EQ(posed_mesh(mesh, pose, 0.0).positions, mesh.positions);
    EXPECT_EQ(posed_mesh(mesh, pose, 0.0).triangles, mesh.triangles);
    const Mesh half = posed_mesh(mesh, pose, 0.5);
    EXPECT_EQ(half.triangles, mesh.triangles);
    for (std::size_t p = 0; p < mesh.positions.size(); ++p) {
        const Vec3d rest = mesh.positions[p];
        const Vec3d end =
            strip_point(int(std::lround(4 * rest.x)), int(std::lround(2 * rest.z)), 0.8);
        EXPECT_LT(glm::distance(half.positions[p], 0.5 * rest + 0.5 * end), 1e-15);
    }
}

TEST(MeshPose, PolygonsAreCutAsTheyAreAtRest) {
    // The pose makes the arrow of the rest a square, whose own fan would be cut elsewhere.
    const std::string faces = "f 1 2 3 4\n";
    const std::string rest = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\n" + faces;
    const std::string posed = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\n" + faces;
    const Mesh mesh = test::read_text("m.obj", rest);
    const MeshPose pose = pose_of(rest, posed);
    for (std::size_t c = 0; c < 6; ++c) {
        const Vec3d p = mesh.positions[mesh.triangles[c / 3][c % 3]];
        EXPECT_EQ(pose.positions[c], p == Vec3d(1, 1, 0) ? Vec3d(4, 4, 0) : p) << c;
    }
}

TEST(MeshPose, WeldedPointsPartWhereThePoseTakesThemApart) {
    // Two triangles with vertices of their own that coincide along an edge.
    const std::string faces = "f 1 2 3\nf 4 5 6\n";
    const std::string rest = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + faces;
    const std::string posed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n" + faces;
    const Mesh mesh = test::read_text("m.obj", rest);
    ASSERT_EQ(mesh.positions.size(), 4u);
    const MeshPose pose = pose_of(rest, posed);
    const PosedPoints points = posed_points(mesh, pose);
    ASSERT_EQ(points.positions.size(), 5u);
    EXPECT_EQ(points.rest[4], mesh.triangles[1][0]);
    EXPECT_EQ(points.positions[points.triangles[0][1]], Vec3d(1, 0, 0));
    EXPECT_EQ(points.positions[points.triangles[1][0]], Vec3d(2, 0, 0));
    EXPECT_EQ(points.triangles[0][2], points.triangles[1][2]);  // (0,1,0) stays one
    EXPECT_EQ(posed_mesh(mesh, pose, 1.0).positions[4], Vec3d(2, 0, 0));
}

TEST(MeshPose, OtherFacesAreRefusedInOneSentence) {
    const std::string rest = strip_obj(0.0), code = "same order";
    const auto refused = [&](const std::string& posed, const std::string& part) {
        expect_error([&] { pose_of(rest, posed); }, ExitCode::invalid_file, part);
        expect_error([&] { pose_of(rest, posed); }, ExitCode::invalid_file, code);
    };
    refused(strip_obj(0.8, 11), "there are 11 faces, but 12 in");
    std::string triangle = strip_obj(0.8);
    triangle.replace(triangle.rfind("f "), std::string::npos, "f 23 25 26\n");
    refused(triangle, "face 12 has 3 corners, but 4 in");
    // Two faces change places.
    std::string swapped = strip_obj(0.8);
    swapped.replace(swapped.rfind("f 23"), std::string::npos, "f 1 3 4 2\n");
    swapped.replace(swapped.find("f 1 3 4 2"), 9, "f 23 25 26 24");
    refused(swapped, "joins other points");
    expect_error([&] { pose_of(rest, "v nan 0 0\nf 1 1 1\n"); }, ExitCode::invalid_file, "posed");
    expect_error([&] { read_own_pose(obj(rest), "smile"); }, ExitCode::usage, "smile");
}

TEST(MeshPose, APoseOfAnotherMeshIsAnErrorNotACrash) {
    const Mesh mesh = test::read_text("m.obj", strip_obj(0.0));
    const MeshPose pose = pose_of(strip_obj(0.0, 3), strip_obj(0.8, 3));
    expect_error([&] { posed_points(mesh, pose); }, ExitCode::runtime, "has 6 triangles");
}

/// A quad of two triangles with two targets, one with normals, below a node that turns and moves.
GltfFile quad_with_targets() {
    GltfFile file;
    const int position = file.positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const int normal = file.positions({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    const int up = file.positions({0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0});
    const int wide = file.positions({0, 0, 0, 3, 0, 0, 3, 0, 0, 0, 0, 0});
    const int tilted = file.positions({0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0});
    file.mesh({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
               {"indices", file.shorts({0, 1, 2, 0, 2, 3})},
               {"targets", {{{"POSITION", up}}, {{"POSITION", wide}, {"NORMAL", tilted}}}}});
    file.root["meshes"][0]["extras"]["targetNames"] = {"up", "wide"};
    file.root["meshes"][0]["weights"] = {0.0, 0.0};
    // A quarter turn about z and a move: (x, y, z) is at (5 - y, x, z).
    file.node({{"mesh", 0},
               {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}},
               {"translation", {5, 0, 0}}});
    return file;
}

TEST(MeshPose, MorphTargetsMoveVerticesInTheScene) {
    const std::string text = quad_with_targets().gltf();
    const FileBuffer file = buffer_from(text, "m.gltf");
    EXPECT_EQ(pose_names(file), (std::vector<std::string>{"up", "wide"}));
    const MeshPose up = read_own_pose(file, "up"), wide = read_own_pose(file, "wide");
    EXPECT_EQ(up.name, "up");
    ASSERT_EQ(up.positions.size(), 6u);
    EXPECT_LT(glm::distance(up.positions[2], Vec3d(4, 1, 2)), 1e-6);
    EXPECT_LT(glm::distance(up.positions[4], Vec3d(4, 1, 2)), 1e-6);
    EXPECT_LT(glm::distance(wide.positions[1], Vec3d(5, 4, 0)), 1e-6);
    // Normals that a target leaves alone are not the posed surface's.
    for (const Vec3f& n : up.normals) EXPECT_EQ(n, Vec3f(0.0f));
    ASSERT_EQ(wide.normals.size(), 6u);
    EXPECT_LT(glm::distance(wide.normals[1], Vec3f(0, std::sqrt(0.5f), std::sqrt(0.5f))), 1e-6f);
    expect_error([&] { read_own_pose(file, "down"); }, ExitCode::usage, "up, wide");
}

TEST(MeshPose, TargetsWithoutNamesHaveNumbers) {
    GltfFile file = quad_with_targets();
    file.root["meshes"][0].erase("extras");
    const std::string text = file.gltf();
    const FileBuffer buffer = buffer_from(text, "m.gltf");
    EXPECT_EQ(pose_names(buffer), (std::vector<std::string>{"0", "1"}));
    EXPECT_EQ(read_own_pose(buffer, "1").positions,
              read_own_pose(buffer_from(quad_with_targets().gltf(), "m.gltf"), "wide").positions);
}

TEST(MeshPose, ATargetThatIsNotFiniteIsRefused) {
    GltfFile file = quad_with_targets();
    const int bad = file.positions({0, 0, 0, std::nanf(""), 0, 0, 0, 0, 0, 0, 0, 0});
    file.root["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = bad;
    const std::string text = file.gltf();
    expect_error([&] { read_own_pose(buffer_from(text, "m.gltf"), "up"); }, ExitCode::invalid_file,
                 "not finite");
}

Vec3d sheared(const Vec3d& p) {
    return {p.x + 0.5 * p.y, 2.0 * p.y - 0.25 * p.z, p.z + p.x};
}

/// The .obj with its points sheared.
std::string sheared_obj(const std::string& path) {
    std::ifstream file(path);
    std::string text, line;
    while (std::getline(file, line)) {
        std::istringstream words(line);
        std::string kind;
        Vec3d p;
        if (words >> kind && kind == "v" && words >> p.x >> p.y >> p.z) {
            p = sheared(p);
            line = fmt::format("v {} {} {}", p.x, p.y, p.z);
        }
        text += line + "\n";
    }
    return text;
}

TEST(MeshPose, OnAPatchAtlasMiddlesOfEdgesStayMiddles) {
    const std::string path = test::binary_folder() + "/meshes/teapot.obj";
    const Mesh mesh = read_mesh(path);
    AtlasOptions options;
    options.kind = AtlasKind::patch;
    options.size = 256;
    options.tries = 1;
    const MeshAtlas atlas = build_atlas(mesh, build_connectivity(mesh), options);
    ASSERT_TRUE(atlas.patches());
    ASSERT_FALSE(atlas.patches()->refined.extra_points.empty());
    const Mesh& drawn = atlas.mesh(mesh);
    const FileBuffer file = read_file(path);
    // The mesh as its own pose: every corner is where the atlas's mesh has it.
    const MeshPose same = atlas_pose(read_pose(file, file), mesh, atlas);
    const MeshPose posed =
        atlas_pose(read_pose(file, obj(sheared_obj(path), "posed.obj")), mesh, atlas);
    ASSERT_EQ(same.positions.size(), 3 * drawn.triangles.size());
    for (std::size_t c = 0; c < same.positions.size(); ++c) {
        const Vec3d& rest = drawn.positions[drawn.triangles[c / 3][c % 3]];
        ASSERT_EQ(same.positions[c], rest) << c;
        // An affine map keeps middles.
        ASSERT_LT(glm::distance(posed.positions[c], sheared(rest)), 1e-12) << c;
    }
    EXPECT_EQ(posed_points(drawn, posed).positions.size(), drawn.positions.size());  // none parts
}

}  // namespace
}  // namespace burl
