// The order and names of parameters: nothing is lost, what matters comes first, and everything has
// a name in words.
#include "app/editor/session/groups.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/base/embedded.h"
#include "app/editor/panels/parameters.h"
#include "app/recipe/edit/key_check.h"
#include "atlas/base/json.h"

namespace burl {
namespace {

std::vector<RecipeLeaf> leaves_of(const std::string& recipe,
                                  const std::vector<std::string>& settings = {}) {
    return recipe_leaves(slider_json(load_recipe(recipe, settings)));
}

std::vector<ParameterGroup> groups_of(const std::string& recipe,
                                      const std::vector<std::string>& settings = {}) {
    const Json json = slider_json(load_recipe(recipe, settings));
    return parameter_groups(recipe_leaves(json), node_words(json));
}

std::vector<std::string> keys(const std::vector<RecipeLeaf>& leaves) {
    std::vector<std::string> found;
    for (const RecipeLeaf& leaf : leaves) found.push_back(leaf.label);
    return found;
}

const ParameterGroup& group(const std::vector<ParameterGroup>& groups, std::string_view name) {
    const auto found = std::ranges::find(groups, name, &ParameterGroup::name);
    EXPECT_NE(found, groups.end()) << name;
    return found == groups.end() ? groups.front() : *found;
}

TEST(ParameterGroups, HoldEveryLeafOfEveryPresetOnce) {
    for (const EmbeddedFile& file : embedded_recipes()) {
        const std::string name(file.name.substr(0, file.name.rfind('.')));
        std::multiset<std::string> there, held;
        for (const RecipeLeaf& leaf : leaves_of(name)) there.insert(leaf.path);
        for (const ParameterGroup& group : groups_of(name)) {
            EXPECT_FALSE(group.first.empty()) << name << " " << group.name;
            EXPECT_FALSE(group.title.empty());
            std::set<std::string> labels;
            for (const auto* part : {&group.first, &group.more})
                for (const RecipeLeaf& leaf : *part) {
                    held.insert(leaf.path);
                    EXPECT_TRUE(labels.insert(leaf.label).second) << leaf.path;
                }
        }
        EXPECT_EQ(held, there) << name;
    }
}

TEST(ParameterGroups, NameNodesAndNumbersInWords) {
    const auto marble = groups_of("marble");
    const NodeWords words = node_words(slider_json(load_recipe("marble")));
    EXPECT_EQ(map_title(words, "texture"), "Colours");
    EXPECT_EQ(number_label(marble, words, "solid.scale"), "Scale and place: scale");
    EXPECT_EQ(number_label(marble, words, "solid.translate.1"), "Scale and place: move y");
    EXPECT_EQ(number_label(marble, words, "texture.input.noise.0.gain"), "Noise 1: roughness");
    EXPECT_EQ(number_label(marble, words, "texture.stops.2.0"), "Colours: stop 3, place");
    EXPECT_EQ(number_label(marble, words, "nowhere"), "nowhere");
    for (const char* preset : {"moonlit-sea", "cloudy-planet", "sine-marble"}) {
        const Json recipe = slider_json(load_recipe(preset));
        const NodeWords names = node_words(recipe);
        const auto groups = parameter_groups(recipe_leaves(recipe), names);
        for (const std::string& path : color_map_paths(recipe))
            EXPECT_NE(map_title(names, path).find("olour"), std::string::npos) << path;
        for (const RecipeNumber& number : recipe_numbers(recipe))
            EXPECT_NE(number_label(groups, names, number.path), number.path);
    }
}

TEST(ParameterGroups, BeginWithWhatChangesTheTextureMost) {
    const auto groups = groups_of("marble");
    EXPECT_EQ(groups[0].name, "solid");
    EXPECT_EQ(groups[0].first.front().label, "scale");
    EXPECT_EQ(groups[1].name, "noise 1");
    const std::vector<std::string> noise = keys(groups[1].first);
    EXPECT_EQ(std::vector(noise.begin(), noise.begin() + 8),
              (std::vector<std::string>{"kind", "fade", "amplitude", "frequency", "octaves", "gain",
                                        "lacunarity", "sum"}));
    EXPECT_EQ(groups.back().name, "recipe");
    EXPECT_TRUE(groups[1].open);
    EXPECT_FALSE(groups.back().open);
    EXPECT_FALSE(group(groups, "quadric").open);
    const std::vector<std::string> more = keys(groups[1].more);
    for (const char* key : {"feature", "radius2", "period", "weights"})
        EXPECT_NE(std::ranges::find(more, key), more.end()) << key;
}

std::vector<std::string> names_of_presets() {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embedded_recipes())
        names.emplace_back(file.name.substr(0, file.name.rfind('.')));
    return names;
}

/// A path may be another recipe's: what has no number there is named by its path.
TEST(ParameterGroups, NameNumbersOfEveryOtherPresetByTheirPaths) {
    std::set<std::string> paths;
    for (const std::string& name : names_of_presets())
        for (const RecipeNumber& number : recipe_numbers(slider_json(load_recipe(name))))
            if (number.path.find(".stops.") == std::string::npos) paths.insert(number.path);
    for (const std::string& name : names_of_presets()) {
        const auto groups = groups_of(name);
        const Json recipe = slider_json(load_recipe(name));
        const auto numbers = recipe_numbers(recipe);
        for (const std::string& path : paths) {
            const bool there = std::ranges::count(numbers, path, &RecipeNumber::path) > 0;
            EXPECT_EQ(number_label(groups, node_words(recipe), path) == path, !there)
                << name << " " << path;
        }
    }
}

TEST(ParameterGroups, WhatIsNoNumberIsNamedByItsPath) {
    const auto groups = groups_of("marble");
    for (const char* path : {"solid.translate.3", "solid.translate.x", "solid.translate.",
                             "solid.scale.0", "texture.stops.x.0", "texture.stops.0",
                             "texture.stops..0", "texture.stops.99999999999999999999.0", ""})
        EXPECT_EQ(number_label(groups, {}, path), path);
}

TEST(ParameterGroups, ShowWhatTheKindOfNoiseKnows) {
    const auto first = [](const char* kind) {
        return keys(
            groups_of("marble", {std::string("texture.input.noise.0.kind=") + kind})[1].first);
    };
    const auto has = [](const std::vector<std::string>& keys, const char* key) {
        return std::ranges::find(keys, key) != keys.end();
    };
    EXPECT_TRUE(has(first("worley"), "feature"));
    EXPECT_FALSE(has(first("worley"), "fade"));
    EXPECT_TRUE(has(first("simplex"), "radius2"));
    EXPECT_FALSE(has(first("perlin"), "fade"));
}

TEST(ParameterGroups, TellNodesApartByWhatTheyAreAndWhereTheyAreUsed) {
    for (const char* recipe : {"cloudy-planet", "oak", "car-paint", "living-planet"}) {
        std::set<std::string> titles;
        for (const ParameterGroup& group : groups_of(recipe)) {
            EXPECT_TRUE(titles.insert(group.title).second) << group.title;
            EXPECT_EQ(group.title.find('.'), std::string::npos) << group.title;
            EXPECT_EQ(group.title.find('_'), std::string::npos) << group.title;
        }
        EXPECT_TRUE(titles.contains("Scale and place"));
        if (recipe == std::string("cloudy-planet")) {
            EXPECT_TRUE(titles.contains("Smoothstep in base colour"));
        }
        if (recipe == std::string("oak")) {
            EXPECT_TRUE(titles.contains("Fbm 2 in radius"));
            EXPECT_TRUE(titles.contains("Pores (smoothstep)"));
            EXPECT_TRUE(titles.contains("Add 4 in roughness"));
        }
    }
}

TEST(ParameterGroups, NumbersAndColoursInPlaceOfNodesHaveSliders) {
    const auto leaves = leaves_of("checks");
    const auto b = std::ranges::find(leaves, "texture.input.b", &RecipeLeaf::path);
    ASSERT_NE(b, leaves.end());
    EXPECT_EQ(b->value, "#23303f");
    EXPECT_EQ(b->parameter->type, ParameterType::color);
    const auto mixed = leaves_of("sine-marble");
    const auto a = std::ranges::find(mixed, "texture.input.a", &RecipeLeaf::path);
    ASSERT_NE(a, mixed.end());
    EXPECT_EQ(a->parameter->type, ParameterType::number);
}

TEST(ParameterLabels, AreWords) {
    EXPECT_EQ(parameter_label("octaves"), "detail (octaves)");
    EXPECT_EQ(parameter_label("fraction_bits"), "fraction bits");
    for (const EmbeddedFile& file : embedded_recipes())
        for (const RecipeLeaf& leaf :
             leaves_of(std::string(file.name.substr(0, file.name.rfind('.')))))
            EXPECT_EQ(parameter_label(leaf.label).find('_'), std::string::npos) << leaf.path;
}

TEST(NextSeed, ComesBackOnlyAfterAllOthers) {
    std::vector<bool> seen(65536, false);
    std::uint32_t seed = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        seed = next_seed(seed);
        ASSERT_LT(seed, seen.size());
        ASSERT_FALSE(seen[seed]) << i;
        seen[seed] = true;
    }
    EXPECT_EQ(seed, 0u);
    EXPECT_GT(next_seed(7) > 7 ? next_seed(7) - 7 : 7 - next_seed(7), 24u);
    EXPECT_LT(next_seed(4294967295U), 65536u);
}

}  // namespace
}  // namespace burl
