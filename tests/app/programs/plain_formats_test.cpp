// PLY, STL and colours of points, read back by readers of the tests' own.
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "atlas/read/read_mesh.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;
using test::slurp;
namespace fs = std::filesystem;
using testing::HasSubstr;

template <class Value>
Value take(const std::string& bytes, std::size_t& at) {
    Value value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}

/// A PLY as its header says, of binary little endian.
struct TinyPly {
    std::vector<std::string> comments;
    std::vector<std::pair<std::string, std::string>> properties;  ///< type and name of vertices
    std::vector<std::vector<double>> vertices;
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::vector<std::array<float, 6>> texcoords;

    explicit TinyPly(const std::string& bytes) {
        const std::size_t end = bytes.find("end_header\n") + 11;
        std::istringstream header(bytes.substr(0, end));
        std::size_t counts[2]{};
        bool of_faces = false, lists_uvs = false;
        for (std::string line; std::getline(header, line);) {
            std::istringstream in(line);
            std::string key, type, name;
            in >> key >> type >> name;
            if (key == "comment") comments.push_back(line);
            if (key == "element") of_faces = type == "face";
            if (key == "element") counts[of_faces] = std::stoul(name);
            if (key == "property" && type != "list") properties.emplace_back(type, name);
            if (line.ends_with(" texcoord")) lists_uvs = true;
        }
        std::size_t at = end;
        for (std::size_t i = 0; i < counts[0]; ++i) {
            auto& vertex = vertices.emplace_back();
            for (const auto& [type, name] : properties)
                vertex.push_back(type == "double"  ? take<double>(bytes, at)
                                 : type == "float" ? double(take<float>(bytes, at))
                                                   : double(take<std::uint8_t>(bytes, at)));
        }
        for (std::size_t i = 0; i < counts[1]; ++i) {
            EXPECT_EQ(take<std::uint8_t>(bytes, at), 3);
            faces.push_back(take<std::array<std::uint32_t, 3>>(bytes, at));
            if (!lists_uvs) continue;
            EXPECT_EQ(take<std::uint8_t>(bytes, at), 6);
            texcoords.push_back(take<std::array<float, 6>>(bytes, at));
        }
        EXPECT_EQ(at, bytes.size());
    }
    std::size_t column(const std::string& name) const {
        for (std::size_t i = 0; i < properties.size(); ++i)
            if (properties[i].second == name) return i;
        ADD_FAILURE() << name;
        return 0;
    }
    double value(std::size_t vertex, const std::string& name) const {
        return vertices[vertex][column(name)];
    }
};

struct PlainFormats : testing::Test {
    Outcome bake(const std::string& mesh, const std::string& out,
                 const std::string& options = "--size 128") const {
        const Outcome ran =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' -q {}", mesh, scratch / out, options));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return ran;
    }
    const Scratch scratch;
};

TEST_F(PlainFormats, PlyHoldsEveryDigitTheNormalsAndTheTexture) {
    const std::string thirds =
        scratch.write("thirds.obj",
                      "v 0.1 0 0\nv 1 0.3333333333333333 0\nv 1 1 0.7\nv 0 1 0\nv 0.5 0.5 2\n"
                      "f 1 2 3 4\nf 1 5 2\nf 2 5 3\nf 3 5 4\nf 4 5 1\n");
    for (const std::string& mesh : {thirds, std::string("sample:cube")}) {
        bake(mesh, "a.ply"), bake(mesh, "a.obj");
        const TinyPly ply(slurp(scratch / "a.ply"));
        const Mesh obj = read_mesh(scratch / "a.obj");
        EXPECT_EQ(ply.properties[0].first, mesh == thirds ? "double" : "float");
        EXPECT_THAT(ply.comments, testing::Contains("comment TextureFile a.png"));
        ASSERT_EQ(ply.faces.size(), obj.triangles.size());
        for (std::size_t c = 0; c < 3 * ply.faces.size(); ++c) {
            const std::uint32_t v = ply.faces[c / 3][c % 3];
            const Vec3d p(ply.value(v, "x"), ply.value(v, "y"), ply.value(v, "z"));
            EXPECT_EQ(p, obj.positions[obj.triangles[c / 3][c % 3]]);
            const Vec3f n(ply.value(v, "nx"), ply.value(v, "ny"), ply.value(v, "nz"));
            EXPECT_LT(glm::length(n - obj.corners.normals[c]), 1e-6f);
            const Vec2d uv(ply.value(v, "s"), 1.0 - ply.value(v, "t"));
            EXPECT_LT(glm::length(uv - obj.corners.uvs[c]), 1e-6);
            EXPECT_EQ(double(ply.texcoords[c / 3][2 * (c % 3)]), ply.value(v, "s"));
            EXPECT_EQ(double(ply.texcoords[c / 3][2 * (c % 3) + 1]), ply.value(v, "t"));
        }
        EXPECT_LE(ply.vertices.size(), 3 * ply.faces.size());
    }
}

TEST_F(PlainFormats, StlHoldsTheSurface) {
    const Outcome ran = bake("sample:cad_part", "a.stl", "--size 128 --atlas quad");
    EXPECT_THAT(ran.err, HasSubstr("not kept: colours"));
    const std::string bytes = slurp(scratch / "a.stl");
    const Mesh mesh = read_mesh(test::mesh_folder() + "/cad_part.obj");
    std::size_t at = 80;
    ASSERT_FALSE(bytes.starts_with("solid"));
    ASSERT_EQ(take<std::uint32_t>(bytes, at), mesh.triangles.size());
    for (const Triangle& triangle : mesh.triangles) {
        const auto normal = take<Vec3f>(bytes, at);
        std::array<Vec3f, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = take<Vec3f>(bytes, at);
            EXPECT_EQ(p[k], Vec3f(mesh.positions[triangle[k]]) + 0.0f);
        }
        const Vec3f cross = glm::cross(p[1] - p[0], p[2] - p[0]);
        if (glm::length(cross) > 1e-3f) {
            EXPECT_LT(glm::length(normal - glm::normalize(cross)), 1e-3f);
        }
        at += 2;
    }
    EXPECT_EQ(at, bytes.size());
    bake(scratch / "a.stl", "b.stl", "--size 128 --atlas quad");
    EXPECT_EQ(slurp(scratch / "b.stl"), bytes);
    EXPECT_EQ(fs::exists(scratch / "a.png"), false);
}

/// The codes of sRGB that `burl eval` gives at points of solid space.
std::vector<std::array<int, 3>> evaluated(const Scratch& scratch, const std::string& recipe,
                                          const std::vector<Vec3d>& points) {
    std::string text;
    for (const Vec3d& p : points) text += fmt::format("{:.17g},{:.17g},{:.17g}\n", p.x, p.y, p.z);
    const std::string file = scratch.write("points.csv", text);
    const Outcome ran =
        run_burl(scratch, fmt::format("eval {} --points '{}' --json", recipe, file));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    std::vector<std::array<int, 3>> codes;
    const nlohmann::json result = nlohmann::json::parse(ran.out);
    for (const auto& point : result["points"]) {
        const std::string hex = point["float64"]["srgb"].get<std::string>().substr(1);
        codes.push_back({std::stoi(hex.substr(0, 2), nullptr, 16),
                         std::stoi(hex.substr(2, 2), nullptr, 16),
                         std::stoi(hex.substr(4, 2), nullptr, 16)});
    }
    return codes;
}

double decoded(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

TEST_F(PlainFormats, ColorsOfPointsAreTheRecipes) {
    const std::string options = "--vertex-colors --recipe marble";
    for (const char* out : {"c.ply", "c.obj", "c.glb"}) bake("sample:cad_part", out, options);
    EXPECT_FALSE(fs::exists(scratch / "c.png"));
    const TinyPly ply(slurp(scratch / "c.ply"));
    std::vector<Vec3d> points;
    for (std::size_t v = 0; v < ply.vertices.size(); ++v)
        points.emplace_back(ply.value(v, "x"), ply.value(v, "y"), ply.value(v, "z"));
    Vec3d low = points[0], high = low;
    for (const Vec3d& p : points) low = glm::min(low, p), high = glm::max(high, p);
    const Vec3d size = high - low;
    const double longest = std::max({size.x, size.y, size.z});
    std::vector<Vec3d> solid;
    for (const Vec3d& p : points) solid.push_back((p - 0.5 * (low + high)) / longest);
    const auto codes = evaluated(scratch, "marble", solid);
    int least = 255, most = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        const std::array<double, 3> found{ply.value(v, "red"), ply.value(v, "green"),
                                          ply.value(v, "blue")};
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], codes[v][k], 1) << v;
        EXPECT_EQ(ply.value(v, "alpha"), 255);
        least = std::min(least, codes[v][0]), most = std::max(most, codes[v][0]);
    }
    EXPECT_GT(most - least, 40);
    const Mesh obj = read_mesh(scratch / "c.obj"), glb = read_mesh(scratch / "c.glb");
    ASSERT_EQ(obj.corners.colors.size(), 3 * ply.faces.size());
    ASSERT_EQ(glb.corners.colors.size(), 3 * ply.faces.size());
    EXPECT_TRUE(glb.corners.uvs.empty());
    for (std::size_t c = 0; c < obj.corners.colors.size(); ++c)
        for (int k = 0; k < 3; ++k) {
            const double code = codes[ply.faces[c / 3][c % 3]][std::size_t(k)] / 255.0;
            EXPECT_NEAR(obj.corners.colors[c][k], decoded(code), 1.5 / 255.0);
            EXPECT_NEAR(glb.corners.colors[c][k], decoded(code), 1.5 / 255.0);
        }
}

TEST_F(PlainFormats, ColorsOfPointsSayWhatTheyLack) {
    EXPECT_THAT(bake("sample:cube", "c.glb", "--vertex-colors --recipe oak").err,
                HasSubstr("bumps"));
    EXPECT_THAT(bake("sample:cube", "c.obj", "--vertex-colors --recipe oak").err,
                HasSubstr("bumps"));
    const std::string clear =
        R"(--vertex-colors --set material.alpha=mask --set 'material.opacity={"node": "fbm"}')";
    EXPECT_THAT(bake("sample:cube", "c.obj", clear).err, HasSubstr("not kept: opacity"));
    EXPECT_THAT(bake("sample:cube", "c.ply", clear).err, testing::Not(HasSubstr("opacity")));
    EXPECT_EQ(run_burl(scratch, fmt::format("bake sample:cube -o '{}' --strict", scratch / "s.stl"))
                  .exit_code,
              5);
    for (const char* wrong :
         {"-o c.stl --vertex-colors", "-o c.png --vertex-colors",
          "-o c.ply --vertex-colors --size 64", "-o c.ply --vertex-colors --levels 2",
          "-o c.ply --vertex-colors --displace 1"}) {
        const Outcome ran = run_burl(scratch, fmt::format("bake sample:cube {}", wrong),
                                     fmt::format("cd '{}' &&", scratch.path().string()));
        EXPECT_EQ(ran.exit_code, 1) << wrong;
        EXPECT_THAT(ran.err, HasSubstr("--vertex-colors")) << wrong;
    }
}

TEST_F(PlainFormats, ColorsOfPointsHaveAShaderBesideThem) {
    const std::string shader = scratch / "c.frag", textures = scratch / "t.frag";
    bake("sample:cube", "c.ply", fmt::format("--vertex-colors -r wood --emit-glsl '{}'", shader));
    bake("sample:cube", "t.ply", fmt::format("--size 16 -r wood --emit-glsl '{}'", textures));
    EXPECT_FALSE(slurp(shader).empty());
    EXPECT_EQ(slurp(shader), slurp(textures));
}

TEST_F(PlainFormats, OutputsAreKnownToBeUpToDate) {
    for (const char* options : {"--size 64", "--vertex-colors"}) {
        bake("sample:cube", "u.ply", options);
        const Outcome again = run_burl(
            scratch, fmt::format("bake sample:cube -o '{}' {}", scratch / "u.ply", options));
        EXPECT_THAT(again.out, HasSubstr("up to date")) << options;
    }
}

}  // namespace
}  // namespace burl
