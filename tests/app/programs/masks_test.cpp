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
    for (const Rgb8& pixel : read_png(scratch / "a.png").pixels()) greys.insert(pixel.r);
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

}  // namespace
}  // namespace burl::test
