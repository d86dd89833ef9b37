// PLY in its three encodings and many layouts, against the same values written by hand.
#include "tests/atlas/support/mesh_files.h"

namespace burl {
namespace {

using test::bytes_of;
using test::corner;
using test::expect_invalid;
using test::read_text;

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string face_list = "property list uchar int vertex_indices\n";

std::string header(const std::string& format, int vertices, const std::string& properties,
                   int faces, const std::string& face_properties = face_list) {
    return "ply\nformat " + format + " 1.0\ncomment # hand made\nelement vertex " +
           std::to_string(vertices) + "\n" + properties + "element face " + std::to_string(faces) +
           "\n" + face_properties + "end_header\n";
}

TEST(ReadPly, AsciiKeepsDoublesAndLines) {
    const Mesh mesh = read_text(
        "a.ply", header("ascii", 3, xyz, 1) + "0.1234567890123456 0 0\n\n1 0 0\n0 1 0\n3 0 1 2");
    EXPECT_EQ(mesh.positions[0].x, 0.1234567890123456);
    EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(ReadPly, BothBinaryOrdersAndEveryType) {
    for (const bool big : {false, true}) {
        // Types and order differ per property; an unknown one and a list lie between.
        std::string body = "ply\r\nformat binary_" + std::string(big ? "big" : "little") +
                           "_endian 1.0\r\nelement vertex 3\r\nproperty double z\r\n"
                           "property int16 y\r\nproperty list uint8 uint16 extra\r\n"
                           "property char quality\r\nproperty float32 x\r\n"
                           "element face 1\r\nproperty uchar flags\r\n"
                           "property list uint ushort vertex_index\r\nend_header\r\n";
        const float third = 1.0f / 3.0f;
        for (int i = 0; i < 3; ++i) {
            body += bytes_of(0.1 * i, big) + bytes_of(std::int16_t(-2 * i), big) +
                    bytes_of(std::uint8_t(i));
            for (int k = 0; k < i; ++k) body += bytes_of(std::uint16_t(7), big);
            body += bytes_of(std::int8_t(-1)) + bytes_of(third * float(i * i), big);
        }
        body += bytes_of(std::uint8_t(9)) + bytes_of(std::uint32_t(3), big);
        for (const int index : {2, 1, 0}) body += bytes_of(static_cast<std::uint16_t>(index), big);
        const Mesh mesh = read_text("a.ply", body);
        ASSERT_EQ(mesh.triangles.size(), 1u);
        EXPECT_EQ(corner(mesh, 0, 0), Vec3d(double(third * 4.0f), -4.0, 0.1 * 2));
        EXPECT_EQ(corner(mesh, 0, 1), Vec3d(double(third), -2.0, 0.1));
        EXPECT_EQ(corner(mesh, 0, 2), Vec3d(0.0));
    }
}

TEST(ReadPly, FacesBeforeVertices) {
    const Mesh mesh = read_text("a.ply", "ply\nformat ascii 1.0\nelement face 1\n" + face_list +
                                             "element vertex 3\n" + xyz +
                                             "end_header\n3 2 1 0\n0 0 0\n1 0 0\n0 1 0\n");
    EXPECT_EQ(corner(mesh, 0, 0), Vec3d(0, 1, 0));
}

TEST(ReadPly, Attributes) {
    const Mesh mesh =
        read_text("a.ply", header("ascii", 3,
                                  xyz + "property float nx\nproperty float ny\nproperty float nz\n"
                                        "property uchar red\nproperty uchar green\n"
                                        "property uchar blue\nproperty float s\nproperty float t\n",
                                  1) +
                               "0 0 0 0 0 5 255 0 51 0.5 0.25\n1 0 0 1 0 0 0 0 0 0 0\n"
                               "0 1 0 0 1 0 0 0 0 1 1\n3 0 1 2\n");
    EXPECT_EQ(mesh.corners.normals[0], Vec3f(0, 0, 1));
    EXPECT_FLOAT_EQ(mesh.corners.colors[0].r, 1.0f);
    EXPECT_NEAR(mesh.corners.colors[0].b, 0.0331048, 1e-6);  // sRGB code 51
    EXPECT_EQ(mesh.corners.colors[0].a, 1.0f);
    EXPECT_EQ(mesh.corners.uvs[0], Vec2d(0.5, 0.75));
}

TEST(ReadPly, TextureCoordinatesPerFace) {
    const Mesh mesh = read_text(
        "a.ply", header("ascii", 4, xyz, 2, face_list + "property list uchar float texcoord\n") +
                     "0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2 6 0.1 0.2 0.3 0.4 0.5 1\n3 2 1 3 0\n");
    ASSERT_EQ(mesh.corners.uvs.size(), 6u);
    EXPECT_EQ(mesh.corners.uvs[1], Vec2d(0.3, 1.0 - 0.4));
    EXPECT_EQ(mesh.corners.uvs[2], Vec2d(0.5, 0.0));
    EXPECT_EQ(mesh.corners.uvs[4], Vec2d(0.0));
}

TEST(ReadPly, Strips) {
    const Mesh mesh = read_text("a.ply", "ply\nformat ascii 1.0\nelement vertex 5\n" + xyz +
                                             "element tristrips 1\n"
                                             "property list int int vertex_indices\nend_header\n"
                                             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n"
                                             "11 0 1 2 3 -1 2 3 4 4 -1 0 1\n");
    ASSERT_EQ(mesh.triangles.size(), 3u);
    for (std::size_t t = 0; t < 3; ++t) {  // all wound the same way
        const Vec3d normal = glm::cross(corner(mesh, t, 1) - corner(mesh, t, 0),
                                        corner(mesh, t, 2) - corner(mesh, t, 0));
        EXPECT_GT(normal.z, 0.0) << t;
    }
    ASSERT_EQ(mesh.notes.sentences.size(), 1u);  // 3 4 4 is a stitch
    EXPECT_NE(mesh.notes.sentences[0].find("1 triangles"), std::string::npos);
}

TEST(ReadPly, OtherElementsAreCounted) {
    const Mesh mesh = read_text("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz +
                                             "element edge 2\nproperty int a\nproperty int b\n"
                                             "element face 1\n" +
                                             face_list +
                                             "element nothing 4000000000\nend_header\n"
                                             "0 0 0\n1 0 0\n0 1 0\n0 1\n1 2\n3 0 1 2\n");
    EXPECT_EQ(mesh.notes.ignored_elements, 2u);
}

TEST(ReadPly, BadAsciiNamesTheLine) {
    const std::string head = header("ascii", 3, xyz, 1);  // 10 lines
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    expect_invalid("a.ply", head + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
                   "a.ply:12: expected a number");
    expect_invalid("a.ply", head + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "a.ply:12: expected a number");
    expect_invalid("a.ply", head + "0 0 0\n1 0 1e200\n0 1 0\n3 0 1 2\n", "a.ply:12: a coordinate");
    expect_invalid("a.ply", head + points + "3 0 1 3\n", "a.ply:14: vertex 3 is used");
    expect_invalid("a.ply", head + points + "3 0 1 -1\n", "a.ply:14: vertex -1 is used");
    expect_invalid("a.ply", head + points + "2 0 1      \n", "a.ply:14: a face needs at least 3");
    expect_invalid("a.ply", head + points + "200 0 1 2\n", "a.ply:14: a list of 200 values");
    expect_invalid("a.ply", head + points + "\n", "the file ends after 0 of 1 rows of 'face'");
    expect_invalid("a.ply", header("ascii", 3, xyz, 0) + points, "holds no face");
}

TEST(ReadPly, BadHeaders) {
    expect_invalid("a.ply", "plx\n", "a.ply:1: a PLY file must begin");
    expect_invalid("a.ply", "ply\nformat text 1.0\n", "a.ply:2: unknown PLY format 'text'");
    expect_invalid("a.ply", "ply\nproperty float x\n", "a.ply:2: a property before");
    expect_invalid("a.ply", "ply\nelement vertex -3\n", "a.ply:2: the number of elements");
    expect_invalid("a.ply", "ply\nelement vertex many\n", "a.ply:2: expected the number");
    expect_invalid("a.ply", "ply\nelement vertex 3\nproperty half x\n",
                   "a.ply:3: 'half' is no PLY");
    expect_invalid("a.ply", "ply\nelement vertex 3\nproperty list float int x\n",
                   "cannot be a float");
    expect_invalid("a.ply", "ply\nformat ascii 1.0\n", "'end_header' is missing");
    expect_invalid("a.ply", "ply\nend_header\n", "names no format");
    expect_invalid("a.ply", "ply\nelement vertex 3\nelement vertex 3\n",
                   "a.ply:3: element 'vertex'");
    expect_invalid("a.ply", header("ascii", 1, "property float x\n", 1) + "0\n3 0 0 0\n",
                   "no properties x, y and z");
    expect_invalid("a.ply", header("ascii", 3, "", 1) + "3 0 1 2\n", "no properties x, y and z");
    expect_invalid("a.ply",
                   header("ascii", 3, xyz, 1, "property int a\n") + "0 0 0\n1 0 0\n0 1 0\n1\n",
                   "'face' has no list");
}

TEST(ReadPly, AbsurdCountsAreRefusedBeforeAllocating) {
    const std::string le = "binary_little_endian";
    auto huge = header("ascii", 3, xyz, 1);
    huge.replace(huge.find("vertex 3"), 8, "vertex 4000000000");
    expect_invalid("a.ply", huge + "0 0 0\n", "announces 4000000000 rows of 'vertex'");
    huge.replace(huge.find("ascii"), 5, le);
    expect_invalid("a.ply", huge + "xxxx", "announces 4000000000 rows of 'vertex'");
    huge = header(le, 0, xyz, 1, "property list uint int vertex_indices\n");
    expect_invalid("a.ply", huge + bytes_of(0xffffffffu) + "xxxx", "a list of 4294967295 values");
}

TEST(ReadPly, TruncatedAndNonFiniteBinary) {
    std::string body = header("binary_little_endian", 3, xyz, 1);
    const std::size_t start = body.size();
    for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) body += bytes_of(v);
    body += bytes_of(std::uint8_t(3));
    for (int i = 0; i < 3; ++i) body += bytes_of(i);
    EXPECT_EQ(read_text("a.ply", body).triangles.size(), 1u);
    for (std::size_t size = start; size < body.size(); ++size)
        expect_invalid("a.ply", body.substr(0, size), "a.ply: ");
    body.replace(start + 16, 4, bytes_of(std::numeric_limits<float>::quiet_NaN()));
    expect_invalid("a.ply", body, "vertex 1 (the first is 0): a coordinate");
}

}  // namespace
}  // namespace burl
