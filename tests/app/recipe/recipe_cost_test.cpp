// The costs of recipes, counted by hand.
#include "app/recipe/recipe_cost.h"

#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/options/command_options.h"
#include "app/recipe/edit/recipe_json.h"

namespace burl {
namespace {

Recipe parsed(const std::string& text) {
    return parse_recipe(text, "r.json");
}

TEST(RecipeCost, CountsTexelsSamplesAndNoises) {
    const Recipe recipe = parsed(
        R"({"burl": 1, "texture": {"node": "fbm", "octaves": 5}, "atlas": {"size": 64},
            "filter": {"kind": "supersample", "samples": 9}})");
    const double noises = noises_per_point(recipe, false);
    EXPECT_GE(noises, 5.0);
    EXPECT_LT(noises, 7.0);
    EXPECT_EQ(noises_per_texel(recipe, false), 9.0 * noises);
    EXPECT_EQ(noises_of_texture(recipe, false), 64.0 * 64 * 9 * noises);
}

TEST(RecipeCost, CountsTheHeightWhereItIsShown) {
    const Recipe recipe = load_recipe("oak");
    ASSERT_FALSE(recipe.bump.empty());
    EXPECT_GT(noises_per_point(recipe, true), noises_per_point(recipe, false) + 1.0);
}

TEST(RecipeCost, ArithmeticIsNotFree) {
    std::string sum = R"({"node": "coordinate"})";
    for (int i = 1; i < 60; ++i)
        sum = R"({"node": "power", "exponent": )" + std::to_string(1 + i) + R"(, "input": )" + sum +
              "}";
    const Recipe plain = parsed(R"({"burl": 1, "texture": )" + sum + "}");
    EXPECT_GE(noises_per_point(plain, false), 59.0 / 8);
    EXPECT_LT(noises_per_point(plain, false), 60.0);
}

TEST(RecipeCost, BurlsOwnRecipesPassAtTheLargestSize) {
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const std::string name(preset.name.substr(0, preset.name.rfind('.')));
        const Recipe recipe = load_recipe(name, {"atlas.kind=patch", "atlas.size=16384",
                                                 "filter.kind=supersample", "filter.samples=16"});
        EXPECT_LT(10.0 * noises_of_texture(recipe, true), RecipeOptions().most_noises) << name;
    }
}

}  // namespace
}  // namespace burl
