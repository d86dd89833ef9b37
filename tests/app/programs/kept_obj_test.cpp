// What an OBJ keeps of the OBJ that it was baked from, read back by a reader of the tests' own.
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/scene/scene.h"
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

/// A face with all that an OBJ says of it; numbers are resolved to what their lines say.
struct FaceText {
    std::string object, group, smoothing, material;
    std::vector<std::string> points, uvs, normals;
    bool operator==(const FaceText&) const = default;
};

struct ObjContent {
    std::vector<FaceText> faces;
    std::vector<std::string> libraries, others;  ///< others: all other lines, resolved
};

/// Reads an OBJ word by word, without any of Burl's code.
class TinyObj {
  public:
    explicit TinyObj(const std::string& path) {
        std::istringstream text(slurp(path));
        for (std::string line; std::getline(text, line);) read(line);
    }
    ObjContent content{};

  private:
    static std::string resolve(const std::string& number, const std::vector<std::string>& lines) {
        if (number.empty()) return "";
        const int n = std::stoi(number);
        return lines.at(std::size_t(n > 0 ? n - 1 : int(lines.size()) + n));
    }
    void read(const std::string& line) {
        std::istringstream in(line);
        std::string key, rest;
        in >> key;
        std::getline(in >> std::ws, rest);
        if (key.empty() || key[0] == '#') return;
        if (key == "v")
            points_.push_back(rest);
        else if (key == "vt")
            uvs_.push_back(rest);
        else if (key == "vn")
            normals_.push_back(rest);
        else if (key == "o")
            now_.object = rest;
        else if (key == "g")
            now_.group = rest;
        else if (key == "s")
            now_.smoothing = rest;
        else if (key == "usemtl")
            now_.material = rest;
        else if (key == "mtllib")
            content.libraries.push_back(rest);
        else if (key == "f" || key == "l")
            corners(key, rest);
        else
            content.others.push_back(line);
    }
    void corners(const std::string& key, const std::string& rest) {
        FaceText face = now_;
        std::istringstream words(rest);
        for (std::string word; words >> word;) {
            std::istringstream numbers(word);
            std::string v, vt, vn;
            std::getline(numbers, v, '/');
            std::getline(numbers, vt, '/');
            std::getline(numbers, vn, '/');
            face.points.push_back(resolve(v, points_));
            face.uvs.push_back(resolve(vt, uvs_));
            face.normals.push_back(resolve(vn, normals_));
        }
        if (key == "f")
            content.faces.push_back(face);
        else
            content.others.push_back(fmt::format("l {}", fmt::join(face.points, "; ")));
    }

    FaceText now_;
    std::vector<std::string> points_, uvs_, normals_;
};

/// A row of boxes without ends, in two objects, of quads and a hexagon, in three materials.
std::string row_of_boxes() {
    std::string text =
        "# a comment\nmtllib my.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0.6 0.8 0\n";
    int count = 0;
    for (int box = 0; box < 4; ++box) {
        text += fmt::format("o Box {} #{}\ng side_{} all\ns {}\n", box, box, box, box);
        const double x = 3.0 * box;
        for (const auto& [y, z] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.25}, {0.0, 1.25}})
            text += fmt::format("v {}.50 {} {}\nv {}.75 {} {}\n", x, y, z, x + 1, y, z);
        constexpr std::array names{"Wood.dark", "Metal shiny", "Wood.light", "Glass"};
        text += fmt::format("usemtl {}\n", names[std::size_t(box)]);
        const int a = count + 1;
        for (int k = 0; k < 4; ++k) {
            const int p = a + 2 * k, q = a + 2 * ((k + 1) % 4);
            if (box == 1)
                text += fmt::format("f {}/1/1 {}/2/1 {}/3/2 {}/1/2\n", p, p + 1, q + 1, q);
            else if (box == 2)
                text += fmt::format("f {0} {1} {2} {3}\n", p - count - 9, p - count - 8,
                                    q - count - 8, q - count - 9);
            else
                text += fmt::format("f {} {} {} {}\n", p, p + 1, q + 1, q);
        }
        text += fmt::format("l {} -1\nfrobnicate {}\n", a, box);
        count += 8;
    }
    text += "v 0 5 0\nv 2 5 0\nv 3 6 0\nv 2 7 0\nv 0 7 0\nv -1 6 0\nf -6 -5 -4 -3 -2 -1\n";
    return text;
}

struct KeptObjFile : testing::Test {
    KeptObjFile() { scratch.write("in.obj", row_of_boxes()); }
    Outcome bake(const std::string& out, const std::string& options = "") const {
        const Outcome ran =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' --size 128 -q {}", scratch / "in.obj",
                                          scratch / out, options));
        EXPECT_EQ(ran.exit_code, 0) << ran.err;
        return ran;
    }
    ObjContent read(const std::string& name) const { return TinyObj(scratch / name).content; }
    const Scratch scratch;
};

TEST_F(KeptObjFile, KeepsObjectsGroupsAndPolygons) {
    const Outcome ran = bake("out.obj");
    const ObjContent before = read("in.obj"), after = read("out.obj");
    EXPECT_EQ(before.others, after.others);
    std::size_t polygons = 0, next = 0;
    for (const FaceText& face : before.faces) {
        ASSERT_LT(next, after.faces.size());
        if (after.faces[next].points == face.points) {
            const FaceText& now = after.faces[next++];
            EXPECT_EQ(now.object, face.object);
            EXPECT_EQ(now.group, face.group);
            EXPECT_EQ(now.smoothing, face.smoothing);
            EXPECT_EQ(now.material, "in_marble");
            polygons += face.points.size() > 3;
            continue;
        }
        next += face.points.size() - 2;  // cut into triangles
    }
    EXPECT_EQ(next, after.faces.size());
    EXPECT_GE(polygons, 8u);
    if (polygons < 17) {
        EXPECT_THAT(ran.err, HasSubstr(fmt::format("the atlas cuts {} of 17", 17 - polygons)));
    }
    EXPECT_EQ(after.libraries, std::vector<std::string>{"out.mtl"});
}

TEST_F(KeptObjFile, ShowsTheTextureThatAGltfShows) {
    for (const char* atlas : {"patch", "quad", "area"}) {
        const std::string options = fmt::format("--atlas {}", atlas);
        bake("a.obj", options), bake("a.glb", options);
        EXPECT_EQ(slurp(scratch / "a.png").size() > 500, true);
        const Mesh obj = read_mesh(scratch / "a.obj"), glb = read_mesh(scratch / "a.glb");
        ASSERT_EQ(obj.triangles.size(), glb.triangles.size()) << atlas;
        for (std::size_t c = 0; c < obj.corners.uvs.size(); ++c) {
            EXPECT_LT(glm::length(obj.corners.uvs[c] - glb.corners.uvs[c]), 1e-6) << atlas << c;
            EXPECT_LT(glm::length(obj.corners.normals[c] - glb.corners.normals[c]), 1e-6f);
            EXPECT_LT(glm::length(obj.positions[obj.triangles[c / 3][c % 3]] -
                                  glb.positions[glb.triangles[c / 3][c % 3]]),
                      1e-5);
        }
    }
}

TEST_F(KeptObjFile, LeavesFacesOfOtherMaterialsAsTheyAre) {
    fs::create_directories(scratch.path() / "out");
    bake("out/b.obj", "--material 'Wood*' --material 'Gl?ss'");
    const ObjContent before = read("in.obj"), after = read("out/b.obj");
    std::map<std::string, int> kept;
    std::vector<FaceText> metal_before, metal_after;
    for (const FaceText& face : before.faces)
        if (face.material == "Metal shiny") metal_before.push_back(face);
    for (const FaceText& face : after.faces) {
        ++kept[face.material];
        if (face.material == "Metal shiny") metal_after.push_back(face);
    }
    ASSERT_EQ(metal_before.size(), 4u);
    EXPECT_EQ(metal_before, metal_after);  // points, texture coordinates and normals by their text
    EXPECT_EQ(kept.size(), 2u);
    EXPECT_EQ(after.libraries, (std::vector<std::string>{"b.mtl", "../my.mtl"}));
    bake("c.obj", "--material Glass");
    EXPECT_EQ(read("c.obj").libraries, (std::vector<std::string>{"c.mtl", "my.mtl"}));
}

TEST_F(KeptObjFile, KeepsColoursOfPointsWhereFacesAreLeft) {
    scratch.write("in.obj",
                  "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 1 1 0\nv 2 0 0\nv 3 0 0 0 0.5 0\n"
                  "v 2 0 1 0 1 1\nusemtl A\nf 1 2 3\nusemtl B\nf 4 5 6\n");
    bake("turned.obj", "--material A --rotate 0,180,0");
    const std::vector<FaceText> faces = read("turned.obj").faces;
    ASSERT_EQ(faces.size(), 2u);
    const auto colors = [](const FaceText& face) {
        std::vector<std::array<float, 3>> result;
        for (const std::string& point : face.points) {
            float x = 0, y = 0, z = 0;
            std::array<float, 3> c{1, 1, 1};
            std::istringstream(point) >> x >> y >> z >> c[0] >> c[1] >> c[2];
            for (float& code : c) code = std::round(code * 1e4f) / 1e4f;
            result.push_back(c);
        }
        return result;
    };
    using Colors = std::vector<std::array<float, 3>>;
    EXPECT_EQ(colors(faces[0]), (Colors{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
    EXPECT_EQ(colors(faces[1]), (Colors{{1, 1, 1}, {0, 0.5, 0}, {0, 1, 1}}));
    EXPECT_EQ(faces[1].points[1].substr(0, 3), "-3 ");  // moved
    bake("whole.obj", "--rotate 0,180,0");              // colours would tint the texture
    EXPECT_EQ(colors(read("whole.obj").faces[1]), (Colors(3, {1, 1, 1})));
}

/// Lines that go on over others, even over empty ones, come out as one.
TEST_F(KeptObjFile, JoinsLinesThatGoOn) {
    scratch.write("in.obj",
                  "v 0 0 0\nv 1 0 0\nv 1 1 0 \\\n\nv 0 \\\r\n1 0\nv 0 0 1\nvn 0 0 1 \\\n\\\n\n"
                  "mtllib \\\nmy.mtl\no Box \\\nof pine\ng ends \\ \nusemtl A\nf 1 2 3//1\n"
                  "f 1 3 \\\n4\nusemtl \\\nB\nf 1//1 3/1 5/1\nvt 0.5 0.25 \\");
    const Mesh before = read_mesh(scratch / "in.obj");
    for (const char* options : {"", "--material A"}) {
        bake("out.obj", options);
        const Mesh after = read_mesh(scratch / "out.obj");
        EXPECT_EQ(after.positions, before.positions) << options;
        EXPECT_EQ(after.triangles, before.triangles);
        const ObjContent content = read("out.obj");
        ASSERT_EQ(content.faces.size(), 3u);
        EXPECT_EQ(content.faces[0].object, "Box  of pine");
        EXPECT_EQ(content.faces[2].points[1], "1 1 0");
    }
    EXPECT_EQ(read("out.obj").libraries, (std::vector<std::string>{"out.mtl", "my.mtl"}));
    EXPECT_EQ(read("out.obj").faces[2].material, "B");
    EXPECT_EQ(read("out.obj").faces[2].uvs[1], "0.5 0.25");
}

/// A material that stays has its own look beside the texture when the file is drawn.
TEST_F(KeptObjFile, IsDrawnWithBothLibraries) {
    scratch.write("my.mtl", "newmtl Glass\nKd 0 1 0\nnewmtl Metal shiny\nKd 1 0 0\n");
    bake("out.obj", "--material 'Wood*'");
    const Scene scene = load_scene(scratch / "out.obj");
    EXPECT_TRUE(scene.notes.empty());
    std::vector<Vec4f> colors;
    for (const Surface& surface : scene.surfaces) colors.push_back(surface.material.factor);
    EXPECT_THAT(colors, testing::IsSupersetOf({Vec4f(1), Vec4f(0, 1, 0, 1), Vec4f(1, 0, 0, 1)}));
    EXPECT_EQ(scene.textures.size(), 1u);
}

/// 20 of 36 triangles are not of Wood; the rows of `wrong` cannot keep them.
TEST_F(KeptObjFile, FacesThatAreNotChosenAreALossWhereTheyAreLeftOut) {
    for (const char* wrong : {"w.glb", "w.ply", "w.stl", "w.obj --displace 1 -r hammered"}) {
        const std::string command = fmt::format("bake '{}' --size 64 --material 'Wood*' -o '{}'/{}",
                                                scratch / "in.obj", scratch.path().string(), wrong);
        const Outcome strict = run_burl(scratch, command + " --strict");
        EXPECT_EQ(strict.exit_code, 5) << wrong;
        EXPECT_THAT(strict.err, HasSubstr("--strict: not kept: 20 triangles that are not chosen"));
        EXPECT_EQ(scratch.files(), 1u) << wrong;
        const Outcome told = run_burl(scratch, command + " --json");
        EXPECT_THAT(told.err, HasSubstr("not kept: 20 triangles that are not chosen; 4 materials"));
        EXPECT_THAT(told.out, HasSubstr("\"20 triangles that are not chosen\""));
        for (const auto& file : fs::directory_iterator(scratch.path()))
            if (file.path().filename() != "in.obj") fs::remove(file.path());
    }
    bake("kept.obj", "--material 'Wood*' --strict");
    bake("kept.png", "--material 'Wood*' --strict");
}

TEST_F(KeptObjFile, WhatAnotherFormatCannotHoldIsTold) {
    EXPECT_THAT(bake("a.glb").err, HasSubstr("not kept: 4 materials; 4 groups; elements other than "
                                             "faces; texture coordinates\n"));
    EXPECT_THAT(bake("a.ply", "--atlas quad").err, HasSubstr("4 groups; 4 objects; elements"));
    const std::string cloud = scratch.write(
        "cloud.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n");
    const std::string command =
        fmt::format("bake '{}' --size 64 -o '{}'", cloud, scratch / "cloud.glb");
    EXPECT_THAT(run_burl(scratch, command).err, HasSubstr("not kept: colours of points\n"));
    EXPECT_EQ(run_burl(scratch, command + " --strict --force").exit_code, 5);
    const std::string plain =
        scratch.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng all\nusemtl one\nf 1 2 3\n");
    EXPECT_EQ(run_burl(scratch, fmt::format("bake '{}' --size 64 -o '{}' --strict", plain,
                                            scratch / "plain.glb"))
                  .exit_code,
              0);
}

TEST_F(KeptObjFile, NamesNodesAfterObjects) {
    bake("a.glb");
    const Mesh mesh = read_mesh(scratch / "a.glb");
    ASSERT_EQ(mesh.parts.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(mesh.parts[i].name, fmt::format("Box {} #{}", i, i));
}

TEST_F(KeptObjFile, RefusesPatternsThatFitNothing) {
    const auto refused = [&](const std::string& options) {
        const Outcome ran = run_burl(
            scratch,
            fmt::format("bake '{}' -o '{}' {}", scratch / "in.obj", scratch / "x.obj", options));
        EXPECT_EQ(ran.exit_code, 1) << options;
        return ran.err;
    };
    EXPECT_THAT(refused("--material 'wood*'"),
                HasSubstr("it has Wood.dark, Metal shiny, Wood.light, Glass"));
    EXPECT_THAT(refused("--material Glass --pose in.obj"), HasSubstr("--pose"));
    EXPECT_FALSE(fs::exists(scratch / "x.obj"));
}

TEST_F(KeptObjFile, TakesPartsOfAMeshInABatchEachByItself) {
    scratch.write("batch.json", R"({"bakes": [
        {"mesh": "in.obj", "output": "b1.obj", "size": 64, "material": "Glass"},
        {"mesh": "in.obj", "output": "b2.obj", "size": 64, "material": ["Wood*", "Glass"]}]})");
    const Outcome ran = run_burl(scratch, fmt::format("batch '{}'", scratch / "batch.json"));
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    const auto carved = [&](const char* name) {
        std::size_t points = 0;
        for (const FaceText& face : read(name).faces)
            if (face.material == "in_marble") points += face.points.size() - 2;
        return points;
    };
    EXPECT_EQ(carved("b1.obj"), 12u);  // with the hexagon
    EXPECT_EQ(carved("b2.obj"), 28u);
}

TEST_F(KeptObjFile, KeepsTheOrderOfTwoMaterialsWithOneName) {
    scratch.write("in.obj",
                  "usemtl in_marble\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl b\n"
                  "v 0 0 1\nf 1 2 4\n");
    bake("d.obj", "--material b");
    const ObjContent after = read("d.obj");
    ASSERT_EQ(after.faces.size(), 2u);
    EXPECT_EQ(after.faces[0].material, "in_marble");
    EXPECT_EQ(after.faces[1].material, "in_marble_2");
    EXPECT_THAT(slurp(scratch / "d.mtl"), HasSubstr("newmtl in_marble_2\n"));
}

}  // namespace
}  // namespace burl
