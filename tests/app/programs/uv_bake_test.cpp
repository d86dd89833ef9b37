// `burl bake --atlas uv`: texture coordinates that survive, UDIM tiles, sizes and refusals.
#include <fmt/format.h>

#include "app/image/image_io.h"
#include "atlas/base/json.h"
#include "atlas/read/read_mesh.h"
#include "tests/app/programs/run_program.h"
#include "tests/atlas/support/gltf_files.h"

namespace burl {
namespace {

using test::Outcome;
using test::run_burl;
using test::Scratch;

/// An OBJ of unit squares side by side in space, each with its own square of coordinates, whose low
/// corner and side are given (v upwards).
struct UvSquare {
    double u, v, side;
};

std::string uv_squares(const std::vector<UvSquare>& squares, double first = 0.0,
                       double height = 1.0) {
    std::string text;
    for (std::size_t i = 0; i < squares.size(); ++i) {
        const auto& [u, v, side] = squares[i];
        for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
            text += fmt::format("v {} {} 0\nvt {} {}\n", first + double(i) + x, y, u + side * x,
                                v + height * side * y);
        const std::size_t p = 4 * i;
        text += fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", p + 1, p + 2, p + 3, p + 4);
    }
    return text;
}

constexpr const char* uv_marble = "--atlas uv --recipe marble --set solid.space=object";

TEST(UvBake, CoordinatesSurvive) {
    const Scratch scratch;
    const std::string mesh =
        scratch.write("a.obj", uv_squares({{0.1, 0.2, 0.3}, {0.5, 0.55, 0.123456}}));
    for (const char* out : {"b.obj", "b.glb"}) {
        const Outcome outcome = run_burl(
            scratch, fmt::format("bake '{}' -o '{}' -s 100 {}", mesh, scratch / out, uv_marble));
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const Mesh before = read_mesh(mesh), after = read_mesh(scratch / out);
        ASSERT_EQ(before.corners.uvs.size(), after.corners.uvs.size());
        for (std::size_t i = 0; i < before.corners.uvs.size(); ++i)
            EXPECT_LT(glm::length(before.corners.uvs[i] - after.corners.uvs[i]), 1e-7) << out;
    }
}

TEST(UvBake, UdimTilesAreTheImagesOfTheirCharts) {
    const Scratch scratch;
    const std::string mesh =
        scratch.write("a.obj", uv_squares({{0.1, 0.1, 0.8}, {1.2, 1.25, 0.7}, {0.1, 1.1, 0.5}}));
    const auto bake = [&](const std::string& from, const std::string& out, const char* more) {
        return run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 64 {} {}", from, scratch / out,
                                             uv_marble, more));
    };
    const Outcome outcome = bake(mesh, "t.png", "--udim --json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_FALSE(test::fs::exists(scratch / "t.png"));
    EXPECT_EQ(
        nlohmann::json::parse(outcome.out)["outputs"],
        nlohmann::json({scratch / "t.1001.png", scratch / "t.1011.png", scratch / "t.1012.png"}));
    // The same charts alone, moved to the first tile.
    const std::vector<std::pair<const char*, std::string>> alone{
        {"t.1001.png", uv_squares({{0.1, 0.1, 0.8}})},
        {"t.1012.png", uv_squares({{0.2, 0.25, 0.7}}, 1.0)},
        {"t.1011.png", uv_squares({{0.1, 0.1, 0.5}}, 2.0)}};
    for (const auto& [tile, text] : alone) {
        ASSERT_EQ(bake(scratch.write("one.obj", text), "one.png", "").exit_code, 0);
        EXPECT_EQ(run_burl(scratch, fmt::format("diff '{}' '{}' --tolerance 1", scratch / tile,
                                                scratch / "one.png"))
                      .exit_code,
                  0)
            << tile;
    }
    EXPECT_NE(bake(mesh, "t.png", "--udim").out.find("up to date"), std::string::npos);
    EXPECT_NE(bake(mesh, "u.png", "").err.find("3 UDIM tiles (1001, 1011, 1012)"),
              std::string::npos);
    EXPECT_NE(bake(mesh, "u.glb", "--udim").err.find("--udim writes textures alone"),
              std::string::npos);
}

TEST(UvBake, OverlapsAreToldOfAllTiles) {
    const Scratch scratch;
    const std::string apart =
        scratch.write("a.obj", uv_squares({{0.1, 0.1, 0.8}, {1.25, 0.25, 0.5}, {1.25, 0.25, 0.5}}));
    const std::string both = scratch.write(
        "b.obj",
        uv_squares({{0.25, 0.25, 0.5}, {0.25, 0.25, 0.5}, {1.25, 0.25, 0.5}, {1.25, 0.25, 0.5}}));
    const auto bake = [&](const std::string& mesh) {
        return run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 64 {} --udim --json --force "
                                             "--uv-overlap first",
                                             mesh, scratch / "t.png", uv_marble));
    };
    for (const auto& [mesh, squares] : {std::pair(apart, 2), {both, 4}}) {
        const int count = 2 * squares, texels = squares / 2 * (32 * 32 - 32);  // but the diagonal
        const Outcome outcome = bake(mesh);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_NE(outcome.err.find(fmt::format("{} triangles share {} texels", count, texels)),
                  std::string::npos)
            << outcome.err;
        const auto atlas = nlohmann::json::parse(outcome.out)["atlas"];
        EXPECT_EQ(atlas["overlapping_triangles"], count);
        EXPECT_EQ(atlas["overlapped_texels"], texels);
    }
}

TEST(UvBake, NothingIsWrittenWhereATileIsRefused) {
    const Scratch scratch;
    const std::string mesh =
        scratch.write("a.obj", uv_squares({{0.1, 0.1, 0.8}, {1.2, 0.2, 0.7}, {1.3, 0.3, 0.5}}));
    const Outcome outcome = run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 64 {} --udim", mesh,
                                                          scratch / "t.png", uv_marble));
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("--uv-overlap first"), std::string::npos);
    EXPECT_EQ(scratch.files(), 1u);
}

TEST(UvBake, FewTexelsOfATextureThatIsNotSquareAreTold) {
    const Scratch scratch;
    const std::string mesh = scratch.write("a.obj", uv_squares({{0.0, 0.0, 1.0}}));
    const auto bake = [&](const char* size) {
        return run_burl(scratch, fmt::format("bake '{}' -o '{}' -s {} {} --json", mesh,
                                             scratch / "a.png", size, uv_marble));
    };
    EXPECT_NE(bake("8x2").err.find("8 texels per triangle at 8 x 2"), std::string::npos);
    const Outcome enough = bake("64x1");
    EXPECT_EQ(enough.err.find("texels per triangle"), std::string::npos) << enough.err;
    EXPECT_EQ(nlohmann::json::parse(enough.out)["capacity"]["texels_per_triangle"], 32.0);
}

TEST(UvBake, TexturesThatAreNotSquareAreThePartOfASquareWithTheSameTexels) {
    const Scratch scratch;
    // In the lower picture half of a square texture, and in all of one half as high.
    const std::string whole = scratch.write("a.obj", uv_squares({{0.0, 0.0, 1.0}}));
    const std::string half = scratch.write("b.obj", uv_squares({{0.0, 0.5, 1.0}}, 0.0, 0.5));
    const auto bake = [&](const std::string& from, const char* out, const char* size) {
        const Outcome outcome =
            run_burl(scratch, fmt::format("bake '{}' -o '{}' -s {} {} --levels 3", from,
                                          scratch / out, size, uv_marble));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    };
    bake(whole, "wide.png", "64x32");
    bake(half, "square.png", "64");
    for (const char* level : {"", ".1", ".2", ".3"}) {
        const Image<Rgb8> wide = read_png(scratch / fmt::format("wide{}.png", level)),
                          square = read_png(scratch / fmt::format("square{}.png", level));
        ASSERT_EQ(wide.width(), square.width());
        ASSERT_EQ(2 * wide.height(), square.height());
        for (std::size_t y = 0; y < wide.height(); ++y)
            for (std::size_t x = 0; x < wide.width(); ++x)
                EXPECT_EQ(wide(x, y), square(x, y)) << level << ' ' << x << ' ' << y;
    }
    bake(whole, "high.png", "16x64");
    EXPECT_EQ(read_png(scratch / "high.png").width(), 16u);
    EXPECT_EQ(read_png(scratch / "high.png").height(), 64u);
    const Outcome patch =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 64x32", whole, scratch / "patch.png"));
    EXPECT_NE(patch.err.find("only uv atlases have it"), std::string::npos) << patch.err;
}

TEST(UvBake, SetsOfCoordinatesAreChosenByNumber) {
    test::GltfFile file;
    const int points = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int first = file.floats({0.5f, 0.5f, 0.75f, 0.5f, 0.5f, 0.75f}, "VEC2", 2),
              second = file.floats({0, 0, 1, 0, 0, 1}, "VEC2", 2);
    file.mesh(
        {{"attributes", {{"POSITION", points}, {"TEXCOORD_0", first}, {"TEXCOORD_1", second}}}});
    file.node({{"mesh", 0}});
    const Scratch scratch;
    const std::string mesh = scratch.write("a.gltf", file.gltf());
    const auto baked = [&](const std::string& more) {
        const Outcome outcome = run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 32 {} {}", mesh,
                                                              scratch / "b.obj", uv_marble, more));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return read_mesh(scratch / "b.obj").corners.uvs;
    };
    EXPECT_EQ(baked("")[0], Vec2d(0.5, 0.5));
    EXPECT_EQ(baked("--uv-set 1")[1], Vec2d(1.0, 0.0));
    const auto refused = [&](const std::string& from, const std::string& more) {
        return run_burl(scratch, fmt::format("bake '{}' -o '{}' {}", from, scratch / "c.glb", more))
            .err;
    };
    EXPECT_NE(refused(mesh, "--atlas uv --uv-set 2").find("has no TEXCOORD_2"), std::string::npos);
    EXPECT_NE(refused("sample:cube", "--uv-set 1").find("--uv-set is for --atlas uv"),
              std::string::npos);
    EXPECT_NE(refused("sample:cube", "--atlas uv --uv-set 1").find("is no glTF"),
              std::string::npos);
}

TEST(UvBake, AGltfKeepsTheCoordinatesThatItIsBakedBy) {
    test::GltfFile file;
    const int points = file.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const std::vector<float> first{0.5f, 0.5f, 0.75f, 0.5f, 0.5f, 0.75f},
        second{0.1f, 0.2f, 0.9f, 0.3f, 0.2f, 0.7f};
    file.mesh({{"attributes",
                {{"POSITION", points},
                 {"TEXCOORD_0", file.floats(first, "VEC2", 2)},
                 {"TEXCOORD_1", file.floats(second, "VEC2", 2)}}}});
    file.node({{"mesh", 0}});
    const Scratch scratch;
    const std::string mesh = scratch.write("a.gltf", file.gltf());
    const Outcome outcome = run_burl(scratch, fmt::format("bake '{}' -o '{}' -s 32 {} --uv-set 1",
                                                          mesh, scratch / "b.gltf", uv_marble));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (std::uint32_t set : {0u, 1u}) {
        ReadOptions options;
        options.uv_set = set;
        const Mesh baked = read_mesh(scratch / "b.gltf", options);
        const std::vector<float>& expected = set == 0 ? first : second;
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(baked.corners.uvs[i], Vec2d(expected[2 * i], expected[2 * i + 1])) << set;
    }
    const auto document = nlohmann::json::parse(test::slurp(scratch / "b.gltf"));
    EXPECT_FALSE(document["meshes"][0]["primitives"][0]["attributes"].contains("TEXCOORD_2"));
    EXPECT_EQ(document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"], 1);
}

}  // namespace
}  // namespace burl
