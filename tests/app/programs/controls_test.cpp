// Materials and their controls from outside: `burl show`, `burl list materials`, and --set of a
// control wherever there is a --set.

#include <gmock/gmock.h>

#include "app/recipe/material_notes.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/recipe/edit/control_samples.h"

namespace burl::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class ControlledProgram : public testing::Test {
  protected:
    const Scratch scratch;
    const std::string planks = scratch.write("planks.json", planks_json);
    const std::string points = scratch.write("points.csv", "0.1,0.2,0.3\n0.3,-0.2,0.05\n");

    Outcome burl(const std::string& arguments) const { return run_burl(scratch, arguments); }
    /// Expects two command lines to print the same.
    void expect_same(const std::string& a, const std::string& b) const {
        const Outcome one = burl(a), other = burl(b);
        EXPECT_EQ(one.exit_code, 0) << one.err;
        EXPECT_EQ(other.exit_code, 0) << other.err;
        EXPECT_EQ(one.out, other.out);
    }
};

TEST_F(ControlledProgram, ShowTellsWhatARecipeIsAndItsJson) {
    const Outcome shown = burl(fmt::format("show '{}'", planks));
    ASSERT_EQ(shown.exit_code, 0) << shown.err;
    EXPECT_TRUE(shown.out.starts_with("Planks\ngroup: wood\nBoards with dirt between them.\n"));
    EXPECT_THAT(shown.out, HasSubstr("\ncontrol  value    range      about\n"
                                     "size     0.5      0.05 to 5  longest side in metres\n"
                                     "width    0.1      0.01 to 1\n"
                                     "light    #c79d6a\n"
                                     "detail   3        1 to 8\n\n"));
    EXPECT_TRUE(shown.out.ends_with(std::string(planks_json) + "\n"));
    EXPECT_EQ(burl(fmt::format("show '{}' --json", planks)).out, std::string(planks_json) + "\n");
    EXPECT_EQ(burl("show marble --json").out, recipe_text("marble").json);
    EXPECT_THAT(burl("show marble").out, testing::Not(HasSubstr("control")));
}

TEST_F(ControlledProgram, APathThatARecipeWithControlsLacksPointsToThem) {
    const auto set = [&](const std::string& setting) {
        const Outcome outcome =
            burl(fmt::format("bake sample:cube -s 8 -o a.png --recipe oak --set {}", setting));
        EXPECT_EQ(outcome.exit_code, 1);
        expect_one_sentence(outcome.err);
        return outcome.err;
    };
    const std::string path = "texture.input.noise.0.seed", hint = "this recipe has no ";
    EXPECT_THAT(set(path + "=7"), HasSubstr(hint + path + ", and `burl show` lists its controls"));
    EXPECT_THAT(set("material.roughness=nonsense"), testing::Not(HasSubstr(hint)));
}

TEST_F(ControlledProgram, ShowRefusesWhatIsNoRecipe) {
    const Outcome unknown = burl("show oakk");
    EXPECT_EQ(unknown.exit_code, 1);
    expect_one_sentence(unknown.err);
    EXPECT_THAT(unknown.err, HasSubstr("did you mean \"oak\"?"));
    const std::string wrong = scratch.write("wrong.json", R"({"controls": [{"name": "a"}]})");
    const Outcome refused = burl(fmt::format("show '{}' --json", wrong));
    EXPECT_EQ(refused.exit_code, 3);
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(refused.err, HasSubstr("controls.0.sets is missing"));
}

TEST_F(ControlledProgram, ListGroupsTheMaterials) {
    const Outcome text = burl("list materials");
    ASSERT_EQ(text.exit_code, 0) << text.err;
    std::string wanted, group;
    for (const MaterialNote& note : material_notes()) {
        if (note.group != group) wanted += (group.empty() ? "" : "\n") + note.group + ":\n";
        group = note.group;
        wanted += fmt::format("  {:<32} {}\n", note.name, note.about);
    }
    EXPECT_EQ(text.out, wanted);
    const Json list = Json::parse(burl("list materials --json").out);
    ASSERT_EQ(list.size(), material_notes().size());
    EXPECT_EQ(list[0]["group"], material_notes()[0].group);
    EXPECT_EQ(list[0]["text"], material_notes()[0].about);
    EXPECT_THAT(burl("list recipes").out, HasSubstr("\nmarble "));
}

TEST_F(ControlledProgram, EvalAndBakeTakeControls) {
    const std::string eval = fmt::format("eval '{}' --points '{}'", planks, points);
    expect_same(eval + " --set size=2", eval + " --set solid.scale=2");
    const std::string bake = "bake sample:cube --size 32 -r '" + planks + "' -o ";
    ASSERT_EQ(burl(fmt::format("{}'{}' --set 'Light=#ff8800'", bake, scratch / "a.png")).exit_code,
              0);
    ASSERT_EQ(burl(fmt::format("{}'{}' --set texture.stops.0.1=#ff8800 --set define.pale=#ff8800",
                               bake, scratch / "b.png"))
                  .exit_code,
              0);
    EXPECT_EQ(slurp(scratch / "a.png"), slurp(scratch / "b.png"));
    const std::string batch =
        scratch.write("batch.json", R"({"bakes": [{"mesh": "sample:cube", "size": 32, "recipe":
            "planks.json", "set": "light=#ff8800", "output": "c.png"}]})");
    ASSERT_EQ(burl(fmt::format("batch '{}'", batch)).exit_code, 0);
    EXPECT_EQ(slurp(scratch / "c.png"), slurp(scratch / "b.png"));
}

TEST_F(ControlledProgram, AFileTellsItsControls) {
    const std::string glb = scratch / "a.glb";
    ASSERT_EQ(
        burl(fmt::format("bake sample:cube --size 32 -r oak --set size=1 -o '{}'", glb)).exit_code,
        0);
    const std::string bytes = slurp(glb);
    EXPECT_THAT(bytes, HasSubstr("ring spacing"));
    EXPECT_THAT(bytes, HasSubstr("longest side of the object in metres"));
}

TEST_F(ControlledProgram, OutOfRangeIsOneSentenceAndNoFile) {
    const Outcome far = burl(
        fmt::format("bake sample:cube -r '{}' --set size=99 -o '{}'", planks, scratch / "a.png"));
    EXPECT_EQ(far.exit_code, 1);
    expect_one_sentence(far.err);
    EXPECT_THAT(far.err, HasSubstr("--set size=99: \"size\" must be a number from 0.05 to 5"));
    EXPECT_EQ(scratch.files(), 2u);
}

}  // namespace
}  // namespace burl::test
