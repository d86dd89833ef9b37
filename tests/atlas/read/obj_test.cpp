// OBJ: what is accepted, what is counted, and the sentence with its line for everything that is
// wrong.
#include "tests/atlas/support/mesh_files.h"

namespace burl {
namespace {

using test::corner;
using test::expect_error;
using test::expect_invalid;
using test::read_text;

const std::string three_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ReadObj, KeepsDoublePrecision) {
    const Mesh mesh = read_text(
        "a.obj", "v 0.1234567890123456 -1e-300 +2.5\nv 1 0 0\nv 0 1.0000000000000002 0\nf 1 2 3\n");
    EXPECT_EQ(mesh.positions[0], Vec3d(0.1234567890123456, -1e-300, 2.5));
    EXPECT_EQ(mesh.positions[2].y, 1.0000000000000002);
    EXPECT_EQ(mesh.name, "a");
}

TEST(ReadObj, NegativeAndForwardIndices) {
    const Mesh mesh =
        read_text("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf -1 -2 -4\n");
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(corner(mesh, 1, 0), Vec3d(5.0));
    EXPECT_EQ(corner(mesh, 1, 1), Vec3d(0, 1, 0));
    EXPECT_EQ(corner(mesh, 1, 2), Vec3d(0.0));
}

TEST(ReadObj, LineEndsContinuationsAndComments) {
    const Mesh mesh =
        read_text("a.obj",
                  "\xef\xbb\xbf# made by hand\r\nv 0 0 0 # origin\r\nv\t1 0 \\\r\n 0\r\n"
                  "v 0 1 0\r\n\r\n   f 1 \\\n 2 \\\n3");
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(corner(mesh, 0, 1), Vec3d(1, 0, 0));
    EXPECT_TRUE(mesh.notes.sentences.empty());
}

TEST(ReadObj, AttributesPerCorner) {
    const Mesh mesh = read_text("a.obj", three_vertices +
                                             "v 1 1 0\nvt 0.25 0.75\nvt 1 0 0\nvn 0 0 2\nvn 3 0 0\n"
                                             "f 1/1/1 2/2/2 3/-1/-1\nf 2//1 4//1 3//1\nf 1 2 4\n");
    ASSERT_EQ(mesh.corners.uvs.size(), 9u);
    ASSERT_EQ(mesh.corners.normals.size(), 9u);
    EXPECT_EQ(mesh.corners.uvs[0], Vec2d(0.25, 0.25));  // v is turned: image row 0 is at the top
    EXPECT_EQ(mesh.corners.uvs[2], Vec2d(1.0, 1.0));
    EXPECT_EQ(mesh.corners.uvs[3], Vec2d(0.0));  // missing
    EXPECT_EQ(mesh.corners.normals[0], Vec3f(0, 0, 1));
    EXPECT_EQ(mesh.corners.normals[1], Vec3f(1, 0, 0));
    EXPECT_EQ(mesh.corners.normals[2], Vec3f(1, 0, 0));
    EXPECT_EQ(mesh.corners.normals[6], Vec3f(0, 0, 1));  // missing: the face's own
    ASSERT_EQ(mesh.notes.sentences.size(), 1u);
    EXPECT_NE(mesh.notes.sentences[0].find("3 corners have no normal"), std::string::npos);
}

TEST(ReadObj, VertexColorsAndWeights) {
    const Mesh mesh = read_text("a.obj", "v 0 0 0 1\nv 1 0 0 0.5 0.25 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_EQ(mesh.corners.colors.size(), 3u);
    EXPECT_EQ(mesh.corners.colors[0], Vec4f(1.0f));
    EXPECT_NEAR(mesh.corners.colors[1].r, 0.2140411, 1e-6);  // sRGB 0.5
    EXPECT_NEAR(mesh.corners.colors[1].g, 0.0508761, 1e-6);  // sRGB 0.25
    EXPECT_EQ(mesh.corners.colors[1].b, 0.0f);
    EXPECT_EQ(mesh.corners.colors[2], Vec4f(1.0f));
}

TEST(ReadObj, CountsWhatItIgnores) {
    const Mesh mesh =
        read_text("a.obj", "mtllib x.mtl\no thing\ng a b\nv 9 9 9\n" + three_vertices +
                               "usemtl red\ns off\np 1\nl 1 2 3\nbogus 1\nf 2 3 4\n");
    EXPECT_EQ(mesh.notes.ignored_elements, 2u);
    EXPECT_EQ(mesh.notes.unreferenced_points, 1u);
    ASSERT_EQ(mesh.notes.sentences.size(), 1u);
    EXPECT_NE(mesh.notes.sentences[0].find("line 12"), std::string::npos);
    ASSERT_EQ(mesh.parts.size(), 1u);
    EXPECT_EQ(mesh.parts[0].triangle_count, 1u);
    EXPECT_EQ(mesh.parts[0].instances.size(), 1u);
}

TEST(ReadObj, PolygonsKeepTheirFaceNumber) {
    const Mesh mesh = read_text("a.obj", three_vertices + "v 1 1 0\nf 1 2 3\nf 1 2 4 3\nf 2 4 3\n");
    EXPECT_EQ(mesh.source_faces, (std::vector<std::uint32_t>{0, 1, 1, 2}));
    EXPECT_EQ(mesh.notes.polygons, 1u);
}

TEST(ReadObj, BadNumbersNameTheLine) {
    for (const std::string bad :
         {"nan", "inf", "-inf", "1e400", "1,5", "0x10", "1.5.2", "--1", "x"})
        expect_invalid("a.obj", "v 0 0 0\nv 1 0 " + bad + "\n", "a.obj:2: expected a coordinate");
    expect_invalid("a.obj", "v 0 0 0\n\nv 1 2\n",
                   "a.obj:3: expected a coordinate, but the line ends");
    expect_invalid("a.obj", "v 0 0 1e101\n", "a.obj:1: the coordinate 1e+101 is too large");
    const Mesh tiny = read_text("a.obj", "v 1e-400 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(tiny.positions[0], Vec3d(0.0));  // an underflow is a zero
}

TEST(ReadObj, BadIndicesNameTheLine) {
    const std::string head = three_vertices;
    expect_invalid("a.obj", head + "f 1 2 0\n", "a.obj:4: the face uses vertex 0");
    expect_invalid("a.obj", head + "f 1 2 3\nf 1 2 4\n",
                   "a.obj:5: the face uses vertex 4, but the file has 3 vertices");
    expect_invalid("a.obj", head + "f 1 2 -4\n", "a.obj:4: the face uses vertex -4");
    expect_invalid("a.obj", head + "f 1 2 99999999999999999999\n",
                   "a.obj:4: expected a vertex index");
    expect_invalid("a.obj", head + "f 1 2 4294967297\n",
                   "a.obj:4: the face uses vertex 4294967297");
    expect_invalid("a.obj", head + "f 1/1 2/1 3/1\n",
                   "a.obj:4: the face uses texture coordinate 1, but the file has 0");
    expect_invalid("a.obj", head + "f 1//7 2 3\n", "a.obj:4: the face uses normal 7");
    expect_invalid("a.obj", head + "f 1 2 3x\n", "a.obj:4: cannot read a face corner");
    expect_invalid("a.obj", head + "f 1 2 a\n", "a.obj:4: expected a vertex index, found 'a'");
    expect_invalid("a.obj", head + "f 1 2 1.5\n", "a.obj:4: cannot read a face corner");
}

TEST(ReadObj, FacesNeedThreeCorners) {
    expect_invalid("a.obj", three_vertices + "f 1 2\n", "a.obj:4: a face needs at least 3 corners");
    expect_invalid("a.obj", three_vertices + "f\n", "a.obj:4: a face needs at least 3 corners");
}

TEST(ReadObj, FilesWithoutSurface) {
    expect_invalid("a.obj", three_vertices, "holds no face");
    expect_invalid("a.obj", "hello world\n", "holds no face");
    expect_invalid("a.obj", "", "the file is empty");
    expect_invalid("a.obj", std::string("\xff\xfev\0 \0", 6), "UTF-16");
}

TEST(ReadMesh, WhatCannotBeOpened) {
    const auto folder = test::test_folder();
    expect_error([&] { read_mesh((folder / "none.obj").string()); }, ExitCode::io, "none.obj");
    std::filesystem::create_directories(folder / "folder.obj");
    expect_error([&] { read_mesh((folder / "folder.obj").string()); }, ExitCode::io,
                 "it is a folder");
    expect_error([&] { read_text("a.fbx", "x"); }, ExitCode::unsupported, "'.fbx'");
    expect_error([&] { read_text("a", "x"); }, ExitCode::unsupported, "without extension");
    EXPECT_EQ(read_text("A.ObJ", three_vertices + "f 1 2 3\n").triangles.size(), 1u);
}

TEST(ReadMesh, FilesNamedAsAnotherFormat) {
    const std::string triangle = three_vertices + "f 1 2 3\n";
    expect_invalid("a.obj", std::string("glTF\2\0\0\0", 8), "the file is a .glb; name it so");
    expect_invalid("a.off", "ply\nformat ascii 1.0\n", "the file is a .ply; name it so");
    for (const char* name : {"a.gltf", "a.glb"}) expect_invalid(name, triangle, "is no glTF");
}

TEST(ReadMesh, NoPermission) {
    const std::string path = test::write_file("a.obj", three_vertices);
    std::filesystem::permissions(path, std::filesystem::perms::none);
    if (std::ifstream(path).good()) GTEST_SKIP() << "this user may read everything";
    expect_error([&] { read_mesh(path); }, ExitCode::io, "Permission denied");
}

}  // namespace
}  // namespace burl
