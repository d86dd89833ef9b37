// Files with triangle strips against those without: the same triangles with the same corners.
#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/base/json_text.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "atlas/file/file_buffer.h"
#include "atlas/gltf/container.h"
#include "atlas/read/read_mesh.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/kept_samples.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;
using testing::HasSubstr;

/// A corner: point, texture coordinate, normal, colour.
using StripCorner = std::vector<double>;
using StripCorners = std::array<StripCorner, 3>;

/// The mesh's triangles by the values of their corners, each begun at its least corner, in order.
std::vector<StripCorners> triangles_of(const std::string& path) {
    const Mesh mesh = read_mesh(path);
    std::vector<StripCorners> triangles;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        StripCorners& corners = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t c = 3 * t + k;
            const auto add = [&](const auto& values) {
                if (values.empty()) return;
                for (int i = 0; i < values[c].length(); ++i)
                    corners[k].push_back(double(values[c][i]));
            };
            const Vec3d point = mesh.positions[mesh.triangles[t][k]];
            corners[k] = {point.x, point.y, point.z};
            add(mesh.corners.uvs);
            add(mesh.corners.normals);
            add(mesh.corners.colors);
        }
        std::ranges::rotate(corners, std::ranges::min_element(corners));
    }
    std::ranges::sort(triangles);
    return triangles;
}

struct StripFiles : testing::Test {
    Outcome bake(const std::string& mesh, const std::string& out,
                 const std::string& options) const {
        const bool textured = options.find("--vertex-colors") == std::string::npos;
        return run_burl(scratch, fmt::format("bake '{}' -o '{}' {} {}", mesh, scratch / out,
                                             textured ? "--size 128" : "", options));
    }
    void expect_same(const std::string& mesh, const std::string& file,
                     const std::string& options) const {
        SCOPED_TRACE(fmt::format("{} {} {}", mesh, file, options));
        const Outcome lists = bake(mesh, "lists" + file, options + " -q");
        const Outcome strips = bake(mesh, "strips" + file, options + " -q --strips");
        ASSERT_EQ(lists.exit_code, 0) << lists.err;
        ASSERT_EQ(strips.exit_code, 0) << strips.err;
        const std::vector<StripCorners> before = triangles_of(scratch / ("lists" + file));
        EXPECT_FALSE(before.empty());
        EXPECT_EQ(before, triangles_of(scratch / ("strips" + file)));
    }
    Json report(const std::string& out, const std::string& options) const {
        const Outcome made = bake("sample:teapot", out, options + " --strips --json");
        EXPECT_EQ(made.exit_code, 0) << made.err;
        return Json::parse(made.out).at("strips");
    }
    const Scratch scratch;
};

TEST_F(StripFiles, HoldTheSameTriangles) {
    for (const char* mesh : {"sample:teapot", "sample:torus", "sample:king"})
        for (const char* file : {".glb", ".gltf", ".ply"})
            for (const char* atlas : {"--atlas patch", "--atlas quad"})
                expect_same(mesh, file, atlas);
    expect_same("sample:king", ".glb", "--recipe hammered");
    expect_same("sample:king", ".ply", "--vertex-colors");
    expect_same("sample:king", ".glb", "--vertex-colors");
}

TEST_F(StripFiles, GoIntoDocumentsThatAreKept) {
    const auto samples = kept_samples();
    for (const char* name : {"two_materials_skin", "instances", "attributes"}) {
        const std::string source = scratch.write(std::string(name) + ".gltf", samples.at(name));
        expect_same(source, ".glb", "--recipe hammered");
    }
    const Json document = Json::parse(split_gltf(read_file(scratch / "strips.glb")).json);
    for (const Json& mesh : document.at("meshes"))
        for (const Json& primitive : mesh.at("primitives")) EXPECT_EQ(primitive.at("mode"), 5);
}

TEST_F(StripFiles, AreCountedInTheReport) {
    const Json ply = report("a.ply", "--atlas patch"), glb = report("a.glb", "--atlas patch");
    EXPECT_EQ(ply.at("triangles"), read_mesh(scratch / "a.ply").triangles.size());
    EXPECT_EQ(ply.at("triangles_left_out"), 0);
    EXPECT_EQ(ply.at("strips"), glb.at("strips"));
    EXPECT_LT(glb.at("indices_per_triangle"), 2.0) << "lists have 3";
    EXPECT_GT(glb.at("border_loops"), 0) << "the atlas has charts";
    const auto document = Json::parse(split_gltf(read_file(scratch / "a.glb")).json);
    std::uint64_t indices = 0;
    for (const Json& mesh : document.at("meshes")) {
        const auto accessor = mesh.at("primitives")[0].at("indices").get<std::size_t>();
        indices += document.at("accessors")[accessor].at("count").get<std::uint64_t>();
    }
    EXPECT_EQ(glb.at("indices"), indices);
}

TEST_F(StripFiles, AreRefusedWhereTheFormatHasNone) {
    for (const char* out : {"a.obj", "a.stl", "a.mtlx", "a.png", "a.exr"}) {
        const Outcome made = bake("sample:torus", out, "--strips");
        EXPECT_EQ(made.exit_code, 1) << out;
        test::expect_one_sentence(made.err);
        EXPECT_THAT(made.err, HasSubstr("--strips"));
        EXPECT_EQ(scratch.files(), 0u);
    }
}

TEST_F(StripFiles, LeaveTrianglesWithARepeatedCornerOutAndSaySo) {
    const std::string mesh =
        scratch.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\nf 2 2 3\n");
    const Outcome made = bake(mesh, "a.ply", "--vertex-colors --strips -q");
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(read_mesh(scratch / "a.ply").triangles.size(), 2u);
    EXPECT_THAT(made.err, HasSubstr("strips hold no triangle with a repeated corner"));
}

}  // namespace
}  // namespace burl
