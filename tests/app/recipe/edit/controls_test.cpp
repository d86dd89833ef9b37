// Controls: a value set by name is what its paths are set to by hand, whatever is written down in
// between; and every way of getting one wrong.
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/recipe_json.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/options/animation.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"
#include "tests/app/recipe/edit/control_samples.h"

namespace burl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Settings = std::vector<std::string>;

Recipe planks(const Settings& settings = {}) {
    return parse_recipe(test::planks_json, "planks", settings);
}

Recipe paint(const Settings& settings = {}) {
    return parse_recipe(test::paint_json, "paint", settings);
}

std::string refusal(ExitCode code, const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        return error.what();
    }
    ADD_FAILURE() << "accepted";
    return {};
}

std::string refused(const Settings& settings) {
    return refusal(ExitCode::usage, [&] { planks(settings); });
}

TEST(Controls, SetTheirPathsAsByHand) {
    EXPECT_EQ(planks({"size=2"}), planks({"solid.scale=2", "bump.height=0.0005"}));
    EXPECT_EQ(planks({"width=0.05"}),
              planks({"define.boards.spacing=0.05", "define.dust.scale=[20,20,20]"}));
    EXPECT_EQ(planks({"light=#ff8800"}),
              planks({"texture.stops.0.1=#ff8800", "define.pale=#ff8800"}));
    EXPECT_EQ(planks({"width=0.05", "size=2", "light=#ff8800"}),
              planks({"solid.scale=2", "bump.height=0.0005", "define.boards.spacing=0.05",
                      "define.dust.scale=[20,20,20]", "texture.stops.0.1=#ff8800",
                      "define.pale=#ff8800"}));
    EXPECT_NE(planks({"size=2"}), planks());
}

TEST(Controls, AreNamedInAnyCaseAndWithBlanks) {
    EXPECT_EQ(planks({"SIZE = 2"}), planks({"size=2"}));
    EXPECT_EQ(paint({"Flake Size=0.5"}), paint({"flake size=0.5"}));
}

TEST(Controls, OfWholeNumbersAreRounded) {
    EXPECT_EQ(planks({"detail=4.4"}), planks({"define.dirt.octaves=4", "define.dirt.seed=8"}));
    EXPECT_EQ(planks({"detail=4.6"}), planks({"define.dirt.octaves=5", "define.dirt.seed=10"}));
}

TEST(Controls, ReachConstantsInEverySpelling) {
    EXPECT_EQ(paint({"colour=#00ff00"}), paint({"texture.value=#00ff00"}));
    EXPECT_NE(paint({"colour=#00ff00"}), paint());
    EXPECT_EQ(paint({"flake size=0.5"}), paint({"define.flakes=0.5", "define.more=1.5"}));
    EXPECT_EQ(paint({"metal=0.5"}).material.metallic, 0.5);
}

TEST(Controls, StayWithTheRecipeThatIsWrittenDown) {
    for (const Recipe& recipe : {planks(), paint(), planks({"size=2"}), paint({"metal=0"})}) {
        const Recipe read = parse_recipe(to_json(recipe), "written");
        EXPECT_EQ(read, recipe);
        EXPECT_FALSE(read.controls.empty() || read.about.empty() || read.group.empty());
    }
    const std::string written = to_json(planks());
    const Settings settings{"size=2", "width=0.05", "light=#ff8800", "detail=6"};
    EXPECT_EQ(parse_recipe(written, "written", settings), planks(settings));
    EXPECT_EQ(with_numbers(planks(), settings), planks(settings));
    const Settings colours{"colour=#00ff00", "flake size=0.5"};
    EXPECT_EQ(with_numbers(paint({"metal=0"}), colours),
              paint({"metal=0", colours[0], colours[1]}));
    EXPECT_EQ(with_numbers(with_numbers(paint(), {"metal=0"}), {"metal=0.25"}),
              paint({"metal=0.25"}));
}

TEST(Controls, HaveTheValueThatStandsInTheRecipe) {
    const auto values = [](const Recipe& recipe) {
        std::vector<std::string> all;
        for (const ControlState& state : control_states(slider_json(recipe)))
            all.push_back(fmt::format("{}={}", state.control.name, state.value.dump()));
        return all;
    };
    EXPECT_THAT(values(planks()),
                ElementsAre("size=0.5", "width=0.1", "light=\"#c79d6a\"", "detail=3"));
    EXPECT_THAT(values(planks({"define.boards.spacing=0.15", "detail=5"})),
                ElementsAre("size=0.5", "width=0.15", "light=\"#c79d6a\"", "detail=5"));
    EXPECT_THAT(values(paint({"metal=0"})),
                ElementsAre("colour=\"#b01020\"", "flake size=0.25", "metal=0"));
    EXPECT_TRUE(values(load_recipe("marble")).empty());
}

TEST(Controls, YieldToWhatIsSetByItself) {
    const Recipe wanted = planks({"solid.scale=2", "bump.height=0.25"});
    EXPECT_EQ(planks({"size=2", "bump.height=0.25"}), wanted);
    EXPECT_EQ(planks({"bump.height=0.25", "size=2"}), wanted);
    EXPECT_EQ(planks({" solid.scale = 2", "bump.height =0.25"}), wanted);
    EXPECT_THAT(refused({"size=2", "solid.scale=3"}), HasSubstr("both set solid.scale"));
    EXPECT_THAT(refused({"Size=2", "size=3"}), HasSubstr("both set solid.scale"));
}

TEST(Controls, RefuseValuesThatTheyCannotHave) {
    EXPECT_EQ(refused({"size=9"}),
              "--set size=9: \"size\" must be a number from 0.05 to 5, the control's range");
    EXPECT_THAT(refused({"size=big"}), HasSubstr("must be a number from 0.05 to 5"));
    EXPECT_THAT(refused({"size="}), HasSubstr("must be a number"));
    EXPECT_THAT(refused({"size"}), HasSubstr("must have the form path=value"));
    EXPECT_THAT(refused({"size=nan"}), HasSubstr("must be a number"));
    EXPECT_THAT(refused({"light=3"}), HasSubstr("must be a colour"));
    EXPECT_THAT(refused({"light=#12"}), HasSubstr("--set light=#12: "));
    EXPECT_THAT(refused({"wdith=3"}), HasSubstr("did you mean \"width\"?"));
    EXPECT_THAT(refused({"define.boards.spacing=3"}),
                HasSubstr("define.boards.spacing=3: define.boards.spacing is 3, must be from 0.01 "
                          "to 1, the range of the control controls.1.name, \"width\""));
    EXPECT_EQ(planks({"controls.1.range.1=4", "width=3"}).controls[1].range->at(1), 4.0);
}

TEST(Controls, AreNotLostBesideWhatTakesThemOrTheirPlace) {
    EXPECT_THAT(refused({"controls=[]", "size=2"}), HasSubstr("takes this control out"));
    EXPECT_THAT(refused({"size=2", "controls.0.name=foo"}), HasSubstr("takes this control out"));
    EXPECT_THAT(refused({R"(solid={"scale":3})", "size=2"}), HasSubstr("both set solid.scale"));
}

TEST(Controls, MoveOverTime) {
    RecipeOptions options;
    options.recipe = "oak";
    const auto frames = frame_recipes(options, {{"size=0.5:1.5"}, 3, false});
    ASSERT_EQ(frames.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(frames[i], load_recipe("oak", {fmt::format("size={}", 0.5 + 0.5 * double(i))}));
    EXPECT_THROW(frame_recipes(options, {{"size=0.5:99"}, 3, false}), Error);
    EXPECT_THROW(frame_recipes(options, {{"siez=0.5:1"}, 3, false}), Error);
    const std::string keys =
        R"(animation={"tracks":[{"path":"bump.height","keys":[[0,0.1],[1,0.2]]}]})";
    EXPECT_THAT(refused({keys, "size=2"}), HasSubstr("the recipe has keys for bump.height"));
    EXPECT_THAT(refused({R"(animation={"tracks":[{"path":"size","keys":[[0,1]]}]})"}),
                HasSubstr("must be the path of one number"));
}

struct WrongControl {
    const char *controls, *says;
};

const WrongControl wrong_controls[] = {
    {R"([{"sets": ["solid.scale"]}])", "controls.0.name is missing"},
    {R"([{"name": "a"}])", "controls.0.sets is missing"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": []}])", "controls.0.sets is empty"},
    {R"([{"name": "", "range": [0.1, 1], "sets": ["solid.scale"]}])", "controls.0.name is \"\""},
    {R"([{"name": " ", "range": [0.1, 1], "sets": ["solid.scale"]}])", "controls.0.name is"},
    {R"([{"name": "a=b", "range": [0.1, 1], "sets": ["solid.scale"]}])", "without \"=\""},
    {R"([{"name": "solid.scale", "range": [0.1, 1], "sets": ["solid.scale"]}])",
     "controls.0.name is \"solid.scale\", must be a name that is no path"},
    {R"([{"name": "define", "range": [0.1, 1], "sets": ["solid.scale"]}])", "no path of a recipe"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.scale"]},
         {"name": "A", "range": [0, 1], "sets": ["solid.translate.0"]}])",
     "controls.1.name is \"A\", must be another name than that of controls.0"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.scal"]}])",
     "controls.0.sets.0 is \"solid.scal\", must be the path of a number or colour that the recipe "
     "has; did you mean \"solid.scale\"?"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.rotate"]}])", "controls.0.sets.0"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.scale = 2 * x"]}])",
     "must be a path alone"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.scale", "solid.translate.0 = y"]}])",
     "controls.0.sets.1"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.scale", "solid.translate.0 ="]}])",
     "controls.0.sets.1"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.scale", "solid.translate.0 = x = 2"]}])",
     "controls.0.sets.1"},
    {R"([{"name": "a", "range": [0.5, 2], "sets": ["solid.scale", "solid.rotate.0 = 1 / (x - 2) + x"]}])",
     "gives no number at 2"},
    {R"([{"name": "a", "range": [0.1, 1], "sets": ["solid.scale", "solid.scale = x"]}])",
     "another path than that of controls.0.sets.0"},
    {R"([{"name": "a", "sets": ["solid.scale"]}])", "controls.0.range is missing"},
    {R"([{"name": "a", "range": [1, 0.1], "sets": ["solid.scale"]}])", "controls.0.range is"},
    {R"([{"name": "a", "range": [1], "sets": ["solid.scale"]}])", "controls.0.range is"},
    {R"([{"name": "a", "range": [0, 1], "sets": ["solid.scale"]}])",
     "controls.0.range.0 is 0, must be from 1e-06 to 1000000 as solid.scale"},
    {R"([{"name": "a", "range": [2, 3], "sets": ["solid.scale"]}])",
     "solid.scale is 1, must be from 2 to 3, the range of the control controls.0.name, \"a\""},
    {R"([{"name": "a", "range": [0, 1], "sets": ["material.base_color.stops.0.1"]}])",
     "controls.0.range is [0,1], must be left out"},
    {R"([{"name": "a", "sets": ["material.base_color.stops.0.1", "material.emissive = x"]}])",
     "colours have no formulas"},
    {R"([{"name": "a", "sets": ["material.base_color.stops.0.1", "solid.scale"]}])",
     "must be the path of a colour"},
    {R"([{"name": "a", "range": [0.1, 1], "set": ["solid.scale"]}])", "did you mean \"sets\"?"},
};

TEST(Controls, AreRefusedWithTheirPath) {
    for (const WrongControl& wrong : wrong_controls) {
        const std::string json = fmt::format(
            R"({{"controls": {}, "material": {{"base_color": {{"node": "color_map", "stops":
                [[0, "#ffffff"]], "input": {{"node": "fbm"}}}}}}}})",
            wrong.controls);
        EXPECT_THAT(refusal(ExitCode::invalid_file, [&] { parse_recipe(json, "wrong"); }),
                    HasSubstr(wrong.says))
            << wrong.controls;
    }
}

TEST(Controls, AreFew) {
    std::string many;
    for (int i = 0; i < 101; ++i)
        many += fmt::format(R"({}{{"name": "{}", "range": [0.5, 2], "sets": ["solid.scale"]}})",
                            i > 0 ? "," : "", i);
    const auto parse = [&] { parse_recipe(fmt::format(R"({{"controls": [{}]}})", many), "many"); };
    EXPECT_THAT(refusal(ExitCode::invalid_file, parse), HasSubstr("101 controls"));
    many.erase(many.rfind(",{"));
    EXPECT_NO_THROW(parse());
}

}  // namespace
}  // namespace burl
