// Recipes with whole materials: names, channels, both spellings, and every way of getting it wrong.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/pipeline/material.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Recipe recipe_of(const std::string& json, const std::vector<std::string>& settings = {}) {
    return parse_recipe(json, "r", settings);
}

std::string problem_of(const std::string& json, const std::vector<std::string>& settings = {}) {
    try {
        recipe_of(json, settings);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), settings.empty() ? ExitCode::invalid_file : ExitCode::usage);
        return error.what();
    }
    ADD_FAILURE() << "accepted: " << json;
    return {};
}

std::vector<std::string> names_of(const std::vector<MaterialPicture>& pictures) {
    std::vector<std::string> names;
    for (const MaterialPicture& picture : pictures) names.push_back(picture.name);
    return names;
}

constexpr const char* oak = R"({
    "define": {
        "rings": {"node": "rings", "spacing": 0.3},
        "moved": {"node": "warp", "input": "rings"},
        "grain": {"node": "add", "a": "moved", "b": {"node": "transform", "scale": [2, 2, 9],
                  "input": {"node": "add", "a": "rings", "b": "moved"}}},
        "light": "#ffeecc"},
    "material": {
        "base_color": {"node": "color_map", "stops": [[0, "#c9a06a"], [1, "#6e4722"]],
                       "input": "grain"},
        "roughness": {"node": "mix", "a": 0.3, "b": 0.8, "amount": "grain"},
        "metallic": 0.25, "emissive": "light", "clearcoat": "rings", "height": "grain"},
    "bump": {"height": 0.01}})";

TEST(MaterialRecipe, IsReadBackFromItsJson) {
    const Recipe recipe = recipe_of(oak);
    EXPECT_EQ(recipe.texture.channels.size(), 3u);
    EXPECT_EQ(recipe.texture.names.size(), 4u);
    EXPECT_EQ(recipe.material.metallic, 0.25);
    EXPECT_FALSE(recipe.bump.empty());
    EXPECT_EQ(parse_recipe(to_json(recipe), "r"), recipe);
    EXPECT_EQ(to_json(parse_recipe(to_json(recipe), "r")), to_json(recipe));
}

TEST(MaterialRecipe, NamesAreOneNodeAtOnePointAndAnotherElsewhere) {
    const TextureGraph graph = recipe_of(oak).texture;
    EXPECT_EQ(graph.names[0].uses.size(), 4u);  // solid point, both warps, and transformed
    EXPECT_EQ(graph.names[1].uses.size(), 2u);
    EXPECT_EQ(graph.names[2].uses.size(), 1u);
}

TEST(MaterialRecipe, WhatNobodyUsesIsKept) {
    const Recipe recipe = recipe_of(R"({"define": {"a": {"node": "fbm"}}, "texture": {"stops":
        [[0, "#102030"]]}})");
    ASSERT_EQ(recipe.texture.names.size(), 1u);
    EXPECT_THAT(to_json(recipe), HasSubstr("\"define\""));
    EXPECT_EQ(parse_recipe(to_json(recipe), "r"), recipe);
}

TEST(MaterialRecipe, ARecipeWithoutAMaterialIsAsItWas) {
    const Recipe recipe = recipe_of(R"({"texture": {"stops": [[0, "#102030"]]}})");
    EXPECT_NE(plain_texture(recipe.texture), nullptr);
    EXPECT_EQ(recipe.material, Material{});
    EXPECT_FALSE(has_pictures(recipe, Packing::gltf));
    EXPECT_THAT(to_json(recipe), testing::Not(HasSubstr("material")));
    EXPECT_NE(plain_texture(recipe_of(R"({"material": {"metallic": 1, "base_color":
        {"stops": [[0, "#102030"]]}}})")
                                .texture),
              nullptr);
}

TEST(MaterialRecipe, SettingsTakeBothSpellings) {
    const Recipe a = recipe_of(oak, {"texture.stops.0.1=#ffffff", "bump.input=rings"});
    EXPECT_EQ(recipe_of(oak, {"material.base_color.stops.0.1=#ffffff", "material.height=rings"}),
              a);
    EXPECT_EQ(recipe_of(oak, {"define.rings.spacing=0.5"}).texture.nodes.size(),
              a.texture.nodes.size());
    EXPECT_EQ(recipe_of(oak, {"material.roughness=0.4"}).material.roughness, 0.4);
    EXPECT_EQ(recipe_of(oak, {"material.roughness=rings"}).texture.channels.size(), 3u);
}

TEST(MaterialRecipe, ABareColourIsABaseColourInAFileAndInASetting) {
    const Recipe file = recipe_of(R"({"material": {"base_color": "#ff8000"}})");
    EXPECT_EQ(recipe_of("{}", {"material.base_color=#ff8000"}).texture, file.texture);
}

TEST(MaterialRecipe, ChannelsBecomeNodesByASetting) {
    for (const char* channel : {"emissive", "sheen", "roughness"}) {
        const std::string node = R"({"node": "fbm"})";
        const Recipe file =
            recipe_of(fmt::format(R"({{"material": {{"{}": {}}}}})", channel, node));
        EXPECT_EQ(recipe_of("{}", {fmt::format("material.{}={}", channel, node)}), file) << channel;
        EXPECT_EQ(file.texture.channels.size(), 1u);
    }
}

TEST(MaterialRecipe, WrongNamesAreToldWithTheirPath) {
    EXPECT_THAT(problem_of(R"({"define": {"a": {"node": "add", "a": "b", "b": 1}, "b": {"node":
        "add", "a": 2, "b": {"node": "abs", "input": "a"}}}, "texture": {"input": "a"}})"),
                HasSubstr("define.a is made of itself: a uses b uses a"));
    EXPECT_THAT(problem_of(R"({"define": {"a": {"node": "abs", "input": "a"}}})"),
                HasSubstr("define.a is made of itself"));
    EXPECT_THAT(problem_of(R"({"define": {"rings": 1}, "material": {"roughness": "ring"}})"),
                HasSubstr("material.roughness is \"ring\", which \"define\" does not name; did you "
                          "mean \"rings\"?"));
    EXPECT_THAT(problem_of(R"({"define": {"c": "#ffffff"}, "material": {"roughness": "c"}})"),
                HasSubstr("material.roughness is \"c\", which gives a colour"));
    EXPECT_THAT(problem_of(R"({"define": {"a.b": 1}})"), HasSubstr("a name of \"define\" must"));
    EXPECT_THAT(problem_of(R"({"define": {"a": "b", "b": 1}})"), HasSubstr("define.a is \"b\""));
    EXPECT_THAT(problem_of(R"({"define": 3})"), HasSubstr("define is 3, must be an object"));
    EXPECT_THAT(problem_of(R"({"define": {"a": {"node": "fbmm"}}})"),
                HasSubstr("define.a.node is \"fbmm\""));
}

TEST(MaterialRecipe, WrongChannelsAreToldWithTheirPath) {
    EXPECT_THAT(problem_of(R"({"material": {"roughness": 2}})"),
                HasSubstr("material.roughness is 2"));
    EXPECT_THAT(problem_of(R"({"material": {"rough": 1}})"),
                HasSubstr("did you mean \"roughness\""));
    EXPECT_THAT(problem_of(R"({"material": {"metallic": {"node": "uv"}}})"), HasSubstr("colour"));
    EXPECT_THAT(problem_of(R"({"material": {"ior": {"node": "fbm"}}})"),
                HasSubstr("material.ior is an object"));
    EXPECT_THAT(problem_of(R"({"material": {"base_color": {"node": "fbmm"}}})"),
                HasSubstr("material.base_color.node is \"fbmm\""));
    EXPECT_THAT(problem_of(R"({"material": {"base_color": "#ffffff"}, "texture": {"stops": []}})"),
                HasSubstr("material.base_color and texture are the same"));
    EXPECT_THAT(problem_of(R"({"material": {"height": {"node": "uv"}}})"),
                HasSubstr("material.height"));
}

/// Each name uses the one before at two points of its own: 2^20 nodes, were they made.
TEST(MaterialRecipe, DoublingNamesAreRefusedAtOnce) {
    std::string define = R"("n0": {"node": "fbm"})";
    for (int i = 1; i <= 20; ++i)
        define +=
            fmt::format(R"(, "n{0}": {{"node": "mix", "a": {{"node": "warp", "input": "n{1}"}},
            "b": {{"node": "warp", "input": "n{1}"}}}})",
                        i, i - 1);
    EXPECT_THAT(problem_of("{\"define\": {" + define + "}, \"texture\": {\"input\": \"n20\"}}"),
                HasSubstr("more than 1000 nodes"));
}

TEST(MaterialRecipe, PackingsHaveTheirPictures) {
    const Recipe recipe = recipe_of(oak);
    EXPECT_THAT(names_of(material_pictures(recipe, Packing::gltf)),
                ElementsAre("orm", "emissive", "clearcoat"));
    EXPECT_THAT(names_of(material_pictures(recipe, Packing::unity)),
                ElementsAre("mask", "emissive", "clearcoat"));
    EXPECT_THAT(names_of(material_pictures(recipe, Packing::separate)),
                ElementsAre("roughness", "emissive", "clearcoat"));
    const auto unreal = material_pictures(recipe, Packing::unreal);
    EXPECT_EQ(unreal[0].plan.components[2].factor, 0.25);
    const auto unity = material_pictures(recipe, Packing::unity)[0].plan.components[3];
    EXPECT_EQ(unity.factor, -1.0);
    EXPECT_EQ(unity.offset, 1.0);
    const Recipe plain = recipe_of(R"({"material": {"occlusion": 0.5}})");
    const auto orm = material_pictures(plain, Packing::gltf);
    ASSERT_EQ(orm.size(), 1u);
    EXPECT_EQ(orm[0].plan.components[0].factor, 0.5);
    EXPECT_THAT(orm[0].slots, ElementsAre("/occlusionTexture"));
}

TEST(MaterialRecipe, KnowsWhatIsTransparent) {
    const auto transparent = [](const char* texture) {
        return is_transparent(recipe_of(std::string("{\"material\": ") + texture + "}"));
    };
    EXPECT_FALSE(transparent(R"({"base_color": "#ffffff"})"));
    EXPECT_TRUE(transparent(R"({"base_color": "#ffffff80"})"));
    EXPECT_FALSE(transparent(R"({"base_color": "#ffffff80", "alpha": "opaque"})"));
    EXPECT_TRUE(transparent(R"({"base_color": {"stops": [[0, "#ffffff00"], [1, "#ffffff"]]}})"));
    EXPECT_FALSE(transparent(R"({"base_color": {"stops": [[0, "#ffffff"], [1, "#000000"]]}})"));
    EXPECT_TRUE(transparent(R"({"opacity": 0.5})"));
    EXPECT_TRUE(transparent(R"({"opacity": {"node": "fbm"}})"));
    EXPECT_FALSE(transparent(R"({"base_color": {"node": "layer_over", "top": "#ffffff80",
        "base": "#000000"}})"));
    EXPECT_TRUE(
        transparent(R"({"base_color": {"node": "mix", "a": "#ffffff80", "b": "#000000"}})"));
}

}  // namespace
}  // namespace burl
