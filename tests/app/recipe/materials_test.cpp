// The materials in the program: every one can be shipped, and its controls do what they say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/base/embedded.h"
#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/formula.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/material_notes.h"
#include "app/recipe/presets.h"
#include "app/recipe/recipe.h"
#include "app/recipe/spelling.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

class Materials : public testing::TestWithParam<std::string> {
  protected:
    const Recipe recipe = load_recipe(GetParam());
    const Json json = respelled(Json::parse(recipe_text(GetParam()).json));
};

TEST_P(Materials, SayWhatTheyAre) {
    EXPECT_TRUE(std::ranges::count(material_groups, recipe.group)) << recipe.group;
    EXPECT_TRUE(recipe.about.size() > 20 && recipe.about.ends_with(".")) << recipe.about;
    EXPECT_FALSE(recipe.name.empty());
    ASSERT_GE(recipe.controls.size(), 3u);
    EXPECT_LE(recipe.controls.size(), 7u);
    EXPECT_EQ(recipe.controls[0].name, "size");
}

TEST_P(Materials, StandAtTheirControlsValues) {
    const std::vector<RecipePlace> places = recipe_places(json);
    for (const ControlState& state : control_states(json)) {
        for (const std::string& entry : state.control.sets) {
            const auto [path, formula] = control_target(entry);
            const Json& now = find_place(places, path)->value;
            if (now.is_string()) {
                EXPECT_EQ(now, state.value) << entry;
                continue;
            }
            const double x = state.value.get<double>();
            const double wanted = formula.empty() ? x : formula_value(formula, x);
            EXPECT_NEAR(now.get<double>(), wanted, 1e-9 * std::abs(wanted)) << entry;
        }
        if (!state.control.range) continue;
        EXPECT_GE(state.value.get<double>(), (*state.control.range)[0]) << state.control.name;
        EXPECT_LE(state.value.get<double>(), (*state.control.range)[1]) << state.control.name;
    }
}

TEST_P(Materials, TakeBothEndsOfEveryRange) {
    for (const RecipeControl& control : recipe.controls) {
        if (!control.range) {
            EXPECT_NO_THROW(load_recipe(GetParam(), {control.name + "=#123456"})) << control.name;
            continue;
        }
        for (const double end : *control.range) {
            const std::string setting = fmt::format("{}={}", control.name, end);
            try {
                const Recipe set = load_recipe(GetParam(), {setting});
                EXPECT_EQ(parse_recipe(to_json(set), "written"), set) << setting;
            } catch (const Error& error) {
                ADD_FAILURE() << error.what();
            }
        }
    }
}

TEST_P(Materials, AreReadBackFromTheirJsonWithTheirControls) {
    const std::string written = to_json(recipe);
    EXPECT_EQ(parse_recipe(written, "written"), recipe);
    const auto before = control_states(json), after = control_states(slider_json(recipe));
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(after[i].value, before[i].value) << before[i].control.name;
        EXPECT_EQ(after[i].control, before[i].control);
    }
}

std::vector<std::string> all_materials() {
    const std::vector<std::string_view> names = material_names();
    return {names.begin(), names.end()};
}

std::string test_name(const testing::TestParamInfo<std::string>& material) {
    std::string name = material.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(All, Materials, testing::ValuesIn(all_materials()), test_name);

TEST(MaterialLibrary, NamesNothingTwice) {
    std::set<std::string_view> names;
    for (const auto& files : {embedded_recipes(), embedded_materials()})
        for (const EmbeddedFile& file : files)
            EXPECT_TRUE(names.insert(file.name).second) << file.name;
}

TEST(MaterialLibrary, IsSortedByGroupAndName) {
    const auto notes = material_notes();
    ASSERT_EQ(notes.size(), embedded_materials().size());
    const auto place = [](const MaterialNote& note) {
        return std::pair(std::ranges::find(material_groups, note.group), note.name);
    };
    for (std::size_t i = 0; i < notes.size(); ++i) {
        EXPECT_EQ(notes[i].about, load_recipe(notes[i].name).about);
        if (i == 0) continue;
        EXPECT_LT(place(notes[i - 1]), place(notes[i]));
    }
}

}  // namespace
}  // namespace burl
