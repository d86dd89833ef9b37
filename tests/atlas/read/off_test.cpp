// OFF and its relatives.
#include "tests/atlas/support/mesh_files.h"

namespace burl {
namespace {

using test::corner;
using test::expect_error;
using test::expect_invalid;
using test::read_text;

const std::string body = "0 0 0\n1 0 0\n0 1 0\n1 1 0.1234567890123456\n3 0 1 2\n4 0 1 3 2\n";

TEST(ReadOff, HeadersInAllPlaces) {
    for (const std::string head : {"OFF\n4 2 0\n", "OFF 4 2 0\n", "# c\n\nOFF # c\n# c\n4 2\n",
                                   "4 2 5\n", "OFF\r\n4 2 0\r\n"}) {
        const Mesh mesh = read_text("a.off", head + body);
        ASSERT_EQ(mesh.triangles.size(), 3u) << head;
        EXPECT_EQ(mesh.positions[3].z, 0.1234567890123456);
        EXPECT_EQ(mesh.source_faces, (std::vector<std::uint32_t>{0, 1, 1}));
        EXPECT_TRUE(mesh.notes.sentences.empty());
    }
}

TEST(ReadOff, NormalsColorsAndTexture) {
    const Mesh c = read_text(
        "a.off", "COFF\n3 1 0\n0 0 0 255 0 51 255\n1 0 0 0 0 0 0\n0 1 0 0 0 0 0\n3 0 1 2\n");
    EXPECT_NEAR(c.corners.colors[0].b, 0.0331048, 1e-6);  // sRGB code 51
    EXPECT_EQ(c.corners.colors[0].a, 1.0f);
    EXPECT_EQ(c.corners.colors[1].a, 0.0f);
    const Mesh f =
        read_text("a.off", "COFF\n3 1 0\n0 0 0 1 0.5 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n");
    EXPECT_NEAR(f.corners.colors[0].g, 0.2140411, 1e-6);  // sRGB 0.5
    EXPECT_EQ(Vec4f(f.corners.colors[0].r, 0.0f, f.corners.colors[0].b, f.corners.colors[0].a),
              Vec4f(1.0f, 0.0f, 0.0f, 1.0f));
    const Mesh all = read_text("a.off",
                               "STCNOFF\n3 1 0\n0 0 0 0 0 3 1 0 0 1 0.25 0.25\n"
                               "1 0 0 1 0 0 0 0 0 1 0 0\n0 1 0 0 1 0 0 0 0 1 1 1\n3 0 1 2\n");
    EXPECT_EQ(all.corners.normals[0], Vec3f(0, 0, 1));
    EXPECT_EQ(all.corners.colors[0], Vec4f(1, 0, 0, 1));
    EXPECT_EQ(all.corners.uvs[0], Vec2d(0.25, 0.75));
    EXPECT_EQ(read_text("a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n")
                  .corners.normals.size(),
              3u);
}

TEST(ReadOff, SaysWhatItIgnores) {
    const Mesh mesh =
        read_text("a.off", "OFF\n3 1 0\n0 0 0 9\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\nmore\n");
    EXPECT_EQ(mesh.notes.sentences.size(), 3u);
}

TEST(ReadOff, BadFilesNameTheLine) {
    expect_invalid("a.off", "OOFF\n", "a.off:1: expected OFF, found 'OOFF'");
    expect_invalid("a.off", "# only\n", "nothing but comments");
    expect_invalid("a.off", "OFF\n", "expected the numbers of vertices and faces");
    expect_invalid("a.off", "OFF\n3\n", "a.off:2: expected the number of faces");
    expect_invalid("a.off", "OFF\n-3 1 0\n", "negative");
    expect_invalid("a.off", "OFF\n4000000000 1 0\n0 0 0\n", "announces 4000000000 vertices");
    expect_invalid("a.off", "OFF\n3 4000000000 0\n0 0 0\n0 0 0\n0 0 0\n", "4000000000 faces");
    expect_invalid("a.off", "OFF\n4 2 0\n0 0 0\n1 x 0\n" + body, "a.off:4: expected a coordinate");
    expect_invalid("a.off", "OFF\n4 2 0\n0 0 0\n1 inf 0\n" + body,
                   "a.off:4: expected a coordinate");
    expect_invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
                   "a.off:6: the face uses vertex 3");
    expect_invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n",
                   "a.off:6: the face uses vertex -1");
    expect_invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1    \n",
                   "a.off:6: a face needs at least 3");
    expect_invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "expected a vertex index");
    expect_invalid("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0       \n\n",
                   "the file ends after 0 of 1 faces");
    expect_invalid("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "holds no face");
    expect_error([] { read_text("a.off", "OFF BINARY\n"); }, ExitCode::unsupported, "binary OFF");
    expect_error([] { read_text("a.off", "4OFF\n3 1 0\n"); }, ExitCode::unsupported, "4OFF");
}

}  // namespace
}  // namespace burl
