// STL in both encodings; and the promise that an STL and the OBJ of the same surface are one mesh.
#include <cmath>

#include "tests/atlas/support/mesh_files.h"

namespace burl {
namespace {

using test::bytes_of;
using test::corner;
using test::expect_invalid;
using test::read_text;

std::string binary_stl(const std::vector<std::array<float, 9>>& facets,
                       const std::string& title = "") {
    std::string body = title + std::string(80 - title.size(), '\0') +
                       bytes_of(static_cast<std::uint32_t>(facets.size()));
    for (const auto& facet : facets) {
        for (int i = 0; i < 3; ++i) body += bytes_of(0.0f);
        for (const float value : facet) body += bytes_of(value);
        body += std::string(2, '\0');
    }
    return body;
}

const std::array<float, 9> one_facet{0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST(ReadStl, BinaryKeepsFloatsExactly) {
    const float third = 1.0f / 3.0f;
    const Mesh mesh = read_text("a.stl", binary_stl({{third, 0, -0.0f, 1, 0, 0, 0, 1, 0}}));
    EXPECT_EQ(mesh.positions[0], Vec3d(double(third), 0.0, 0.0));
    EXPECT_FALSE(std::signbit(mesh.positions[0].z));  // -0 became 0
    EXPECT_TRUE(mesh.corners.normals.empty());
}

TEST(ReadStl, ABinaryFileMayBeginWithSolid) {
    EXPECT_EQ(read_text("a.stl", binary_stl({one_facet}, "solid facet endsolid")).triangles.size(),
              1u);
    const Mesh longer = read_text("a.stl", binary_stl({one_facet}, "solid") + "tail");
    EXPECT_EQ(longer.triangles.size(), 1u);
    EXPECT_EQ(longer.notes.sentences.size(), 1u);
}

TEST(ReadStl, Ascii) {
    const Mesh mesh = read_text("a.stl",
                                "solid two words\r\n  FACET NORMAL nan nan nan\r\n outer loop\r\n"
                                "vertex 0.1234567890123456 0 0\nvertex 1 0 0\nvertex 0 1e0 0\n"
                                "endloop\nendfacet\nfacet normal 0 0 1 outer loop vertex 0 0 0 "
                                "vertex 1 1 0 vertex 0 1 0 endloop endfacet\nendsolid two words");
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(mesh.positions[0].x, 0.1234567890123456);
    EXPECT_EQ(corner(mesh, 1, 1), Vec3d(1, 1, 0));
    EXPECT_EQ(mesh.notes.merged_points, 1u);
}

TEST(ReadStl, AsciiMayHaveAMark) {
    const std::string text =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid a\n";
    EXPECT_EQ(read_text("a.stl", "\xef\xbb\xbf" + text).positions,
              read_text("a.stl", text).positions);
}

TEST(ReadStl, SameMeshAsItsObj) {
    // A bumpy grid: floats in the STL, the same values with 17 digits in the OBJ.
    const int n = 12;
    const auto height = [](int x, int y) {
        return std::sin(0.7f * float(x)) * std::cos(0.9f * float(y));
    };
    std::string obj;
    std::vector<std::array<float, 9>> facets;
    const auto point = [&](int x, int y) {
        return std::array<float, 3>{0.1f * float(x), 0.1f * float(y),
                                    x == 3 ? -0.0f : height(x, y)};
    };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const auto p = point(x, y);
            obj += fmt::format("v {:.17g} {:.17g} {:.17g}\n", p[0], p[1], p[2]);
        }
    const auto add = [&](std::array<std::array<int, 2>, 3> t) {
        std::array<float, 9> facet{};
        obj += "f";
        for (std::size_t k = 0; k < 3; ++k) {
            const auto p = point(t[k][0], t[k][1]);
            std::copy(p.begin(), p.end(), facet.begin() + static_cast<std::ptrdiff_t>(3 * k));
            obj += fmt::format(" {}", t[k][1] * n + t[k][0] + 1);
        }
        obj += "\n";
        facets.push_back(facet);
    };
    for (int y = n - 2; y >= 0; --y)
        for (int x = 0; x + 1 < n; ++x) {
            add({{{x, y}, {x + 1, y}, {x, y + 1}}});
            add({{{x + 1, y}, {x + 1, y + 1}, {x, y + 1}}});
        }
    const Mesh from_stl = read_text("a.stl", binary_stl(facets));
    const Mesh from_obj = read_text("a.obj", obj);
    EXPECT_EQ(from_stl.positions.size(), static_cast<std::size_t>(n * n));
    EXPECT_EQ(from_stl.positions, from_obj.positions);
    EXPECT_EQ(from_stl.triangles, from_obj.triangles);
    const ReadOptions loose{.weld = 0.05};
    EXPECT_EQ(read_text("a.stl", binary_stl(facets), loose).triangles,
              read_text("a.obj", obj, loose).triangles);
}

TEST(ReadStl, BadFiles) {
    const std::string good = binary_stl({one_facet, one_facet});
    for (std::size_t size = 1; size < good.size(); ++size)
        expect_invalid("a.stl", good.substr(0, size), "a.stl: ");
    expect_invalid("a.stl", good.substr(0, 150), "announces 2 triangles, but is cut off after 1");
    std::string huge = good;
    huge.replace(80, 4, bytes_of(0xffffffffu));
    expect_invalid("a.stl", huge, "announces 4294967295 triangles");
    std::string infinite = good;
    infinite.replace(84 + 50 + 12, 4, bytes_of(std::numeric_limits<float>::infinity()));
    expect_invalid("a.stl", infinite, "triangle 1 has a coordinate");
    expect_invalid("a.stl", std::string(84, '\0'), "holds no face");
    expect_invalid("a.stl", "solid x\nendsolid x\n", "holds no face");

    const std::string head = "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
    expect_invalid("a.stl", head + "vertex 1 inf 0\n", "a.stl:5: expected a coordinate");
    expect_invalid("a.stl", head + "vertex 1 0 0\nendloop\n", "a.stl:6: a facet needs 3 corners");
    expect_invalid("a.stl", head, "the file ends inside a facet");
    expect_invalid("a.stl", head + "cube 1\n", "a.stl:5: 'cube' is no STL keyword");
    expect_invalid("a.stl", "solid\nvertex 0 0 0\n", "a.stl:2: a vertex outside");
}

}  // namespace
}  // namespace burl
