// Masks of the shape from outside: in a recipe's material, as pictures of their own, and where the
// program refuses them.
#include <gmock/gmock.h>

#include "app/image/image_io.h"
#include "app/surface/sample_meshes.h"
#include "atlas/base/json.h"
#include "atlas/read/read_mesh.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

using testing::HasSubstr;

const char* const dusty = R"({"atlas": {"size": 64}, "texture": {"node": "mix", "a": "#000000",
    "b": "#ffffff", "amount": {"node": "clamp", "input": {"node": "facing"}}}})";

TEST(Masks, AreBakedIntoATexture) {
    const Scratch scratch;
    const std::string recipe = scratch.write("dusty.json", dusty);
    const Outcome outcome = run_burl(
        scratch,
        fmt::format("bake sample:cube -o '{}' --recipe '{}' --json", scratch / "a.png", recipe));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto stages = nlohmann::json::parse(outcome.out)["stages"];
    EXPECT_EQ(stages["masks"]["runs"], 1);
    std::set<int> greys;
    const Image<Rgb8> image = read_png(scratch / "a.png");
    for (const Rgb8& pixel : image.pixels()) greys.insert(pixel.r);
    EXPECT_TRUE(greys.contains(0) && greys.contains(255));
}

TEST(Masks, AreRefusedWhereThereAreNoTexels) {
    const Scratch scratch;
    const std::string recipe = scratch.write("dusty.json", dusty);
    const std::string points = scratch.write("p.csv", "0,0,0\n"), out = scratch / "a.png";
    const std::string bake = fmt::format("bake sample:cube -o '{}' --recipe '{}'", out, recipe);
    for (const std::string& command :
         {fmt::format("eval '{}' --points '{}'", recipe, points),
          fmt::format("render sample:cube --direct --recipe '{}' -o '{}'", recipe, out),
          fmt::format("metrics sample:cube --levels --recipe '{}'", recipe),
          fmt::format("{} --emit-glsl '{}'", bake, scratch / "a.frag")}) {
        const Outcome outcome = run_burl(scratch, command);
        EXPECT_EQ(outcome.exit_code, 5) << command;
        EXPECT_THAT(outcome.err, HasSubstr("its node \"facing\" is worked out from the mesh"));
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    }
    EXPECT_FALSE(fs::exists(out));
}

TEST(Masks, AreReadAtPointsOfAMeshThatIsNamed) {
    const Scratch scratch;
    const std::string recipe = scratch.write("edge.json", R"({"texture": {"node": "fbm"},
        "material": {"height": {"node": "height_in_box", "axis": "x"},
                     "roughness": {"node": "facing", "direction": [1, 0, 0]}},
        "solid": {"space": "object"}})");
    // Off the side x = 1 of the cube from -1 to 1, and on its side y = 1.
    const std::string points = scratch.write("p.csv", "1.5,0.2,0.3\n-0.25,1,0.25\n");
    const auto eval = [&](const std::string& more) {
        return run_burl(scratch,
                        fmt::format("eval '{}' --points '{}' --json {}", recipe, points, more));
    };
    const Outcome height = eval("--channel height --mesh sample:cube");
    ASSERT_EQ(height.exit_code, 0) << height.err;
    const auto at = [](const Outcome& outcome, std::size_t point) {
        return nlohmann::json::parse(outcome.out)["points"][point]["float64"];
    };
    const Box3 box = bounding_box(sample_mesh("sample:cube"));
    const double side = box.size().x;
    EXPECT_NEAR(at(height, 0)["value"].get<double>(), 1.0, 1e-5);
    EXPECT_NEAR(at(height, 1)["value"].get<double>(), (-0.25 - box.low.x) / side, 1e-5);
    EXPECT_NEAR(at(height, 1)["gradient"][0].get<double>(), 1.0 / side, 1e-12);
    EXPECT_EQ(at(height, 1)["gradient"][1].get<double>(), 0.0);
    const Outcome rough = eval("--channel roughness --mesh sample:cube --set solid.space=object");
    ASSERT_EQ(rough.exit_code, 0) << rough.err;
    EXPECT_EQ(at(rough, 0)["value"].get<double>(), 1.0);
    EXPECT_EQ(at(rough, 1)["value"].get<double>(), 0.0);
    for (const std::string& wrong : {std::string("--mesh sample:cube"),
                                     std::string("--channel height --set solid.space=unit")}) {
        const Outcome outcome = eval(wrong);
        EXPECT_NE(outcome.exit_code, 0) << wrong;
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    }
    EXPECT_THAT(eval("--channel height").err, HasSubstr("name the mesh with --mesh"));
}

TEST(Masks, MovePointsOfADisplacedMesh) {
    const Scratch scratch;
    const std::string recipe = scratch.write("worn.json", R"({"texture": {"node": "fbm"},
        "material": {"height": {"node": "curvature", "radius": 0.2}}, "bump": {"height": 0.1}})");
    const Outcome outcome = run_burl(
        scratch, fmt::format("bake sample:cube -o '{}' --recipe '{}' --size 64 --displace 3",
                             scratch / "a.glb", recipe));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Vec3d plain = bounding_box(sample_mesh("sample:cube")).size();
    const Vec3d worn = bounding_box(read_mesh(scratch / "a.glb")).size();
    EXPECT_GT(worn.x, 1.01 * plain.x);  // its corners stick out
}

TEST(Masks, AreWrittenBesideAnOutput) {
    const Scratch scratch;
    const std::string bake = fmt::format(
        "bake sample:cube -o '{}' --size 64 --channels occlusion,curvature", scratch / "a.png");
    const Outcome outcome = run_burl(scratch, bake);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(scratch.files(), 4u);  // with the record
    const Image<Rgb8> open = read_png(scratch / "a_occlusion.png");
    EXPECT_EQ(open.width(), 64u);
    int white = 0;
    for (const Rgb8& pixel : open.pixels()) white += pixel.g == 255;
    EXPECT_GT(white, 64 * 64 / 2);  // a box hides nothing of its sky
    EXPECT_TRUE(fs::exists(scratch / "a_curvature.png"));
    EXPECT_THAT(run_burl(scratch, bake).out, HasSubstr("up to date"));
    fs::remove(scratch / "a_curvature.png");
    EXPECT_EQ(run_burl(scratch, bake).exit_code, 0);
    EXPECT_TRUE(fs::exists(scratch / "a_curvature.png"));
}

TEST(Masks, LightIsWrittenInColour) {
    const Scratch scratch;
    const std::string bake =
        fmt::format("bake sample:cube -o '{}' --size 64 --channels lighting", scratch / "a.png");
    ASSERT_EQ(run_burl(scratch, bake + " --depth 16").exit_code, 0);
    EXPECT_EQ(scratch.files(), 3u);  // with the record
    int warm = 0, cold = 0;          // in the sun, and in the sky's light alone
    const Image<Rgb8> light = read_png(scratch / "a_lighting.png");
    for (const Rgb8& pixel : light.pixels()) {
        warm += pixel.r > pixel.b;
        cold += pixel.b > pixel.r;
    }
    EXPECT_GT(warm, 64 * 64 / 6);
    EXPECT_GT(cold, 64 * 64 / 6);
}

TEST(Masks, RefusesChannelsThatThereAreNot) {
    const Scratch scratch;
    const std::string bake = fmt::format("bake sample:cube -o '{}' --channels ", scratch / "a.png");
    EXPECT_EQ(run_burl(scratch, bake + "colour").exit_code, 1);
    const Outcome twice = run_burl(scratch, bake + "part,part");
    EXPECT_EQ(twice.exit_code, 1);
    EXPECT_THAT(twice.err, HasSubstr("part is there twice"));
    EXPECT_EQ(run_burl(scratch, bake + "part --atlas quad --compress 0.1").exit_code, 1);
    EXPECT_EQ(scratch.files(), 0u);
}

}  // namespace
}  // namespace burl::test
