// Masks of the shape from outside: in a recipe's material, as pictures of their own, and where the
// program refuses them.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "app/image/image_io.h"
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
    EXPECT_EQ(twice.exit_code, 2);
    EXPECT_THAT(twice.err, HasSubstr("a_part.png"));
    EXPECT_EQ(run_burl(scratch, bake + "part --atlas quad --compress 0.1").exit_code, 1);
    EXPECT_EQ(scratch.files(), 0u);
}

}  // namespace
}  // namespace burl::test
