// Recipes as node graphs. What their nodes compute is held to MaterialX's own shaders by
// tests/peers/materialx_recipes.mjs, where these are installed.
#include "app/materialx/write/recipe.h"

#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "tests/app/support/xml_elements.h"

namespace burl::materialx {
namespace {

RecipeDocument document_of(const std::string& json) {
    return recipe_document(parse_recipe(json, "test.json"), {});
}

std::string refusal_of(const std::string& json) {
    try {
        document_of(json);
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::unsupported);
        return e.what();
    }
    return "";
}

std::size_t count(const std::string& document, const std::string& tag) {
    const auto all = xml_elements(document);
    return std::size_t(
        std::ranges::count_if(all, [&](const FoundElement& one) { return one.tag == tag; }));
}

TEST(MaterialXRecipe, TheObjectsPositionGoesThroughTheRecipesScale) {
    const std::string text = document_of(R"({"name": "r", "solid": {"scale": 4},
        "texture": {"node": "combine", "red": {"node": "coordinate"}}})")
                                 .text;
    expect_whole_document(text);
    EXPECT_EQ(count(text, "position"), 1u);
    bool scaled = false;
    for (const FoundElement& one : xml_elements(text))
        scaled |= one.inside == "multiply_1" && one["value"] == "4";
    EXPECT_TRUE(scaled) << text;
}

TEST(MaterialXRecipe, EqualNodesAreWrittenOnce) {
    const std::string text = document_of(R"({"texture": {"node": "combine",
        "red": {"node": "sin", "input": {"node": "coordinate"}},
        "green": {"node": "sin", "input": {"node": "coordinate"}},
        "blue": {"node": "abs", "input": {"node": "sin", "input": {"node": "coordinate"}}}}})")
                                 .text;
    EXPECT_EQ(count(text, "sin"), 1u);
    EXPECT_EQ(count(text, "absval"), 1u);
}

TEST(MaterialXRecipe, ChannelsBecomeOutputsAndNumbersInputs) {
    const RecipeDocument document = document_of(R"({"name": "r",
        "texture": {"node": "layer_over", "top": "#ff000080", "base": "#00ff0000"},
        "material": {"roughness": {"node": "coordinate"}, "metallic": 0.75, "occlusion": {"node": "coordinate"},
                     "emissive": {"node": "combine", "red": {"node": "coordinate"}}, "height": {"node": "coordinate"}},
        "bump": {"height": 0.5}, "filter": {"kind": "exact"},
        "controls": [{"name": "gloss", "range": [0, 1], "sets": ["material.metallic"]}]})");
    expect_whole_document(document.text);
    std::vector<std::string> outputs;
    for (const FoundElement& one : xml_elements(document.text))
        if (one.tag == "output") outputs.push_back(one["name"]);
    std::ranges::sort(outputs);
    EXPECT_EQ(outputs, (std::vector<std::string>{"base_color", "emissive", "height", "occlusion",
                                                 "opacity", "roughness"}));
    EXPECT_EQ(count(document.text, "displacement"), 1u);
    std::string notes;
    for (const std::string& note : document.notes) notes += note + '\n';
    for (const char* lost : {"filter exact", "controls", "displacement", "occlusion"})
        EXPECT_NE(notes.find(lost), std::string::npos) << notes;
}

TEST(MaterialXRecipe, NamesEveryNodeWithoutEquivalentByItsPlace) {
    const std::string refusal = refusal_of(R"({"name": "stone", "texture": {"node": "mix",
        "a": {"node": "scale", "a": "#ff0000", "b": {"node": "fbm"}}, "b": {"node": "ramp"}, "amount": {"node": "cells"}},
        "material": {"roughness": {"node": "occlusion"}, "metallic": {"node": "sin", "input": {"node": "coordinate"}}}})");
    for (const char* named :
         {"stone", "a.b (fbm)", "amount (cells)", "roughness (occlusion)", "burl bake"})
        EXPECT_NE(refusal.find(named), std::string::npos) << refusal;
    for (const char* fine : {"ramp", "sin", "mix"})
        EXPECT_EQ(refusal.find(std::string("(") + fine), std::string::npos) << refusal;
    EXPECT_NE(refusal_of(R"({"texture": {"node": "stripes"}, "bump": {"input": {"node": "fbm"}}})")
                  .find("bump.input"),
              std::string::npos);
}

}  // namespace
}  // namespace burl::materialx
