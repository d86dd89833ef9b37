// Every preset's sliders: each leaf stands for a value that the recipe has, and setting it to what
// it is changes nothing.
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/base/embedded.h"
#include "app/recipe/edit/settings.h"
#include "atlas/base/json.h"

namespace burl {
namespace {

std::string preset_name(const EmbeddedFile& file) {
    return std::string(file.name.substr(0, file.name.rfind('.')));
}

TEST(RecipeLeaves, SetToTheirOwnValuesLeaveEveryPresetAsItIs) {
    for (const EmbeddedFile& file : embedded_recipes()) {
        const Recipe recipe = load_recipe(preset_name(file));
        const Json json = Json::parse(to_json(recipe));
        const std::vector<RecipeLeaf> leaves = recipe_leaves(json);
        ASSERT_GT(leaves.size(), 15u) << file.name;
        std::vector<std::string> settings;
        for (const RecipeLeaf& leaf : leaves)
            settings.push_back(fmt::format("{}={}", leaf.path, leaf.value.dump()));
        EXPECT_EQ(parse_recipe(json.dump(), preset_name(file), settings), recipe) << file.name;
    }
}

TEST(RecipeLeaves, PathsAreUniqueAndGroupsNameTheirPlace) {
    const Json json = Json::parse(to_json(load_recipe("cloudy-planet")));
    std::set<std::string> paths;
    for (const RecipeLeaf& leaf : recipe_leaves(json)) {
        EXPECT_TRUE(paths.insert(leaf.path).second) << leaf.path;
        EXPECT_TRUE(leaf.path.ends_with(leaf.label)) << leaf.path;
    }
    const auto leaves = recipe_leaves(json);
    const auto found =
        std::ranges::find(leaves, "texture.opacity.input.input.strength", &RecipeLeaf::path);
    ASSERT_NE(found, leaves.end());
    EXPECT_EQ(found->value, 0.6);
    EXPECT_EQ(found->group, "layer_over > smoothstep > transform > warp");
    EXPECT_NE(std::ranges::find(leaves, "texture.base.input.noise.0.octaves", &RecipeLeaf::path),
              leaves.end());
}

TEST(RecipeLeaves, StrokesOfPaintHaveNone) {
    Recipe recipe = load_recipe("marble");
    const Json plain = Json::parse(to_json(recipe));
    recipe.paint.resize(2);
    EXPECT_EQ(slider_json(recipe), plain);
    EXPECT_EQ(recipe_leaves(Json::parse(to_json(recipe))).size(), recipe_leaves(plain).size());
}

/// A field of colour in its place would look like black and put a colour where the name stands.
TEST(RecipeLeaves, NamesHaveNone) {
    const Recipe recipe = parse_recipe(
        R"({"define": {"a": {"node": "fbm"}}, "texture": {"node": "mix", "b": "#ff0000", "amount": "a"}})",
        "named");
    std::vector<std::string> inputs;
    for (const RecipeLeaf& leaf : recipe_leaves(slider_json(recipe)))
        if (leaf.path.starts_with("texture.")) inputs.push_back(leaf.path);
    EXPECT_EQ(inputs, (std::vector<std::string>{"texture.a", "texture.b"}));
}

TEST(RecipeLeaves, FindsTheColorMaps) {
    EXPECT_EQ(color_map_paths(Json::parse(to_json(load_recipe("marble")))),
              std::vector<std::string>{"texture"});
    EXPECT_EQ(color_map_paths(Json::parse(to_json(load_recipe("cloudy-planet")))),
              std::vector<std::string>{"texture.base"});
}

}  // namespace
}  // namespace burl
