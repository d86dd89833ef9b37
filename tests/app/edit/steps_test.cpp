// Single steps of building against recipes written by hand.
#include "app/edit/steps.h"

#include <gtest/gtest.h>

#include "app/edit/node_kinds.h"
#include "app/edit/paint_layers.h"
#include "procedural/graph/evaluator.h"
#include "tests/app/edit/edit_cases.h"

namespace burl {
namespace {

using test::empty_recipe;
using test::recipe_with;
using test::refusal;

const char* const rings = R"("define": {"rings": {"node": "fract", "input": {"node": "multiply",
        "a": 9, "b": {"node": "distance", "weights": [1, 1, 0]}}}},
    "texture": {"node": "color_map", "wrap": "clamp", "stops": [[0, "#a47747"], [1, "#c69d69"]],
                "input": "rings"},
    "material": {"roughness": {"node": "add", "a": 0.4, "b": "rings"}})";

TEST(BuildSteps, ANewNodeGoesOnWithWhatStoodThere) {
    const GraphEdit mixed = add_node(empty_recipe(), "texture", "mix amount=0.25");
    EXPECT_EQ(mixed.recipe, recipe_with(R"("texture": {"node": "mix", "a": "#808080", "b": 1,
                                                       "amount": 0.25})"));
    EXPECT_EQ(mixed.path, "texture");
    EXPECT_EQ(mixed.words, "add mix");
    const GraphEdit turned = add_node(mixed.recipe, "texture", "transform scale=[2,2,2]");
    EXPECT_EQ(turned.recipe,
              recipe_with(R"("texture": {"node": "transform", "scale": [2, 2, 2], "input":
                  {"node": "mix", "a": "#808080", "b": 1, "amount": 0.25}})"));
}

TEST(BuildSteps, AMapOverAConstantColourBeginsInItsMiddle) {
    EXPECT_EQ(add_node(empty_recipe(), "texture", "color_map").recipe,
              recipe_with(R"("texture": {"node": "color_map", "wrap": "clamp", "input": 0.5})"));
}

TEST(BuildSteps, ANodeThatFindsNoInputIsKeptUnderAName) {
    const Recipe mixed = add_node(empty_recipe(), "texture", "mix").recipe;
    EXPECT_EQ(add_node(mixed, "texture", "marble").recipe,
              recipe_with(R"("texture": {"node": "marble"},
                  "define": {"mix": {"node": "mix", "a": "#808080"}})"));
}

TEST(BuildSteps, ANodeWithoutAPlaceIsThereForLater) {
    const GraphEdit loose = add_node(empty_recipe(), "", "fbm octaves=3");
    EXPECT_EQ(loose.path, "define.fbm");
    EXPECT_EQ(add_node(loose.recipe, "", "fbm").path, "define.fbm_2");
    EXPECT_EQ(loose.recipe, recipe_with(R"("texture": {"node": "constant", "value": "#808080"},
                             "define": {"fbm": {"node": "fbm", "octaves": 3}})"));
}

TEST(BuildSteps, AChannelThatIsLeftOutGoesOnWithItsNumber) {
    const GraphEdit edit = add_node(empty_recipe(), "material.roughness", "multiply b=2");
    EXPECT_EQ(edit.recipe, recipe_with(R"("texture": {"node": "constant", "value": "#808080"},
        "material": {"roughness": {"node": "multiply", "a": 0.6, "b": 2}})"));
}

TEST(BuildSteps, AColourWhereANumberIsWantedGivesItsLuminance) {
    const GraphEdit edit = add_node(empty_recipe(), "material.metallic", "color_map");
    EXPECT_EQ(edit.recipe, recipe_with(R"("texture": {"node": "constant", "value": "#808080"},
        "material": {"metallic": {"node": "split", "channel": "luminance",
            "input": {"node": "color_map", "wrap": "clamp", "input": 0}}})"));
    EXPECT_EQ(edit.path, "material.metallic.input");
}

TEST(BuildSteps, EveryNodeCanBeAddedAnywhere) {
    for (const NodeType& type : graph_table()) {
        const std::string name(type.name);
        for (const char* place : {"texture", "texture.a", "texture.amount", "bump.input",
                                  "material.roughness", "material.emissive", ""}) {
            const Recipe mixed = add_node(empty_recipe(), "texture", "mix").recipe;
            const auto add = [&] { return add_node(mixed, place, name); };
            if (name == "image") {
                EXPECT_NE(refusal(add).find("file is missing"), std::string::npos);
                continue;
            }
            EXPECT_EQ(refusal(add), "") << name << " at " << place;
        }
    }
}

TEST(BuildSteps, WhatIsMisspeltIsToldWithTheNearestWord) {
    const Recipe recipe = empty_recipe();
    EXPECT_EQ(refusal([&] { return add_node(recipe, "texture", "wrinkles"); }),
              "there is no node \"wrinkles\"; did you mean \"wrinkled\"?");
    EXPECT_NE(refusal([&] { return add_node(recipe, "texture", "fbm octavs=3"); }).find("octaves"),
              std::string::npos);
    EXPECT_NE(refusal([&] { return add_node(recipe, "texture.b", "fbm"); }).find("no input"),
              std::string::npos);
    EXPECT_NE(refusal([&] { return add_node(recipe, "define.x", "fbm"); }), "");
    EXPECT_NE(refusal([&] { return add_node(recipe, "texture", ""); }), "");
}

TEST(BuildSteps, AnInputTakesADeletedNodesPlace) {
    const Recipe recipe = recipe_with(rings);
    EXPECT_EQ(delete_nodes(recipe, {"define.rings"}).recipe,
              recipe_with(R"("define": {"rings": {"node": "multiply", "a": 9,
                      "b": {"node": "distance", "weights": [1, 1, 0]}}},
                  "texture": {"node": "color_map", "wrap": "clamp", "input": "rings",
                              "stops": [[0, "#a47747"], [1, "#c69d69"]]},
                  "material": {"roughness": {"node": "add", "a": 0.4, "b": "rings"}})"));
    EXPECT_EQ(delete_nodes(recipe, {"material.roughness"}).recipe,
              recipe_with(R"("define": {"rings": {"node": "fract", "input": {"node": "multiply",
                      "a": 9, "b": {"node": "distance", "weights": [1, 1, 0]}}}},
                  "texture": {"node": "color_map", "wrap": "clamp", "input": "rings",
                              "stops": [[0, "#a47747"], [1, "#c69d69"]]},
                  "material": {"roughness": "rings"})"))
        << "a node before a constant";
}

TEST(BuildSteps, ANameWithoutANodeGoesWithItsUses) {
    const Recipe recipe = recipe_with(rings);
    const GraphEdit edit =
        delete_nodes(recipe, {"define.rings", "define.rings.input", "define.rings.input.b"});
    EXPECT_EQ(edit.recipe, recipe_with(R"("texture": {"node": "color_map", "wrap": "clamp",
            "stops": [[0, "#a47747"], [1, "#c69d69"]], "input": 0.5},
        "material": {"roughness": {"node": "add", "a": 0.4, "b": 0}})"));
    EXPECT_EQ(edit.words, "delete 3 nodes");
}

TEST(BuildSteps, ADeletedPartIsWhatItWasBefore) {
    const Recipe recipe = recipe_with(R"("texture": {"node": "marble"},
        "material": {"roughness": {"node": "fbm"}}, "bump": {"height": 3, "input": {"node": "fbm"}})");
    EXPECT_EQ(delete_nodes(recipe, {"texture", "material.roughness", "bump.input"}).recipe,
              empty_recipe());
    EXPECT_NE(refusal([&] { return delete_nodes(recipe, {}); }), "");
    EXPECT_NE(refusal([&] { return delete_nodes(recipe, {"texture.a"}); }), "");
}

TEST(BuildSteps, AReplacedNodeLeavesWhatFits) {
    const Recipe recipe = recipe_with(R"("texture": {"node": "mix", "a": {"node": "marble"},
        "b": "#ff0000", "amount": {"node": "fbm", "octaves": 3, "seed": 7}})");
    EXPECT_EQ(replace_node(recipe, "texture.amount", "windy").recipe,
              recipe_with(R"("texture": {"node": "mix", "a": {"node": "marble"}, "b": "#ff0000",
                  "amount": {"node": "windy", "octaves": 3, "seed": 7}})"));
    // By name, then in the order of the inputs.
    EXPECT_EQ(to_json(replace_node(recipe, "texture", "blend mode=screen").recipe),
              to_json(recipe_with(R"("texture": {"node": "blend", "mode": "screen",
                      "top": {"node": "fbm", "octaves": 3, "seed": 7},
                      "base": {"node": "marble"}})")));
    EXPECT_EQ(replace_node(recipe, "texture", "constant value=\"#123456\"").recipe,
              recipe_with(R"("texture": {"node": "constant", "value": "#123456"},
                  "define": {"marble": {"node": "marble"},
                             "fbm": {"node": "fbm", "octaves": 3, "seed": 7}})"));
}

TEST(BuildSteps, AConnectedOutputIsSharedUnderAName) {
    const Recipe recipe = recipe_with(R"("texture": {"node": "mix", "a": "#ff0000", "b": "#00ff00",
        "amount": {"node": "fbm"}})");
    const GraphEdit edit = connect(recipe, "texture.amount", "material.roughness");
    EXPECT_EQ(edit.recipe, recipe_with(R"("define": {"fbm": {"node": "fbm"}},
        "texture": {"node": "mix", "a": "#ff0000", "b": "#00ff00", "amount": "fbm"},
        "material": {"roughness": "fbm"})"));
    EXPECT_EQ(edit.words, "connect fbm to roughness");
    EXPECT_EQ(edit.path, "define.fbm");
    EXPECT_EQ(connect(edit.recipe, "material.roughness", "texture.a").recipe,
              recipe_with(R"("define": {"fbm": {"node": "fbm"}},
        "texture": {"node": "mix", "a": "fbm", "b": "#00ff00", "amount": "fbm"},
        "material": {"roughness": "fbm"})"));
}

TEST(BuildSteps, WhatAWireTakesThePlaceOfIsKept) {
    const Recipe recipe = recipe_with(R"("texture": {"node": "mix", "a": {"node": "marble"},
        "b": {"node": "uv"}})");
    EXPECT_EQ(connect(recipe, "texture.a", "texture.b").recipe,
              recipe_with(R"("define": {"marble": {"node": "marble"}, "uv": {"node": "uv"}},
                  "texture": {"node": "mix", "a": "marble", "b": "marble"})"));
    EXPECT_EQ(move_node(recipe, "texture.a", "texture").recipe,
              recipe_with(R"("texture": {"node": "marble"},
                  "define": {"mix": {"node": "mix", "a": 0, "b": {"node": "uv"}}})"));
    EXPECT_EQ(move_node(recipe, "texture.a", "material.emissive").recipe,
              recipe_with(R"("texture": {"node": "mix", "a": 0, "b": {"node": "uv"}},
                  "material": {"emissive": {"node": "marble"}})"));
    EXPECT_EQ(disconnect(recipe, "texture.b").recipe,
              recipe_with(R"("texture": {"node": "mix", "a": {"node": "marble"}},
                  "define": {"uv": {"node": "uv"}})"));
    EXPECT_NE(refusal([&] { return disconnect(recipe, "texture.amount"); }), "");
}

TEST(BuildSteps, CirclesAreRefusedByTheirNames) {
    const Recipe recipe = recipe_with(R"("define": {
            "veins": {"node": "warp", "input": {"node": "add", "a": "grain", "b": 1}},
            "grain": {"node": "fract", "input": {"node": "fbm"}}},
        "texture": {"node": "color_map", "input": "veins"})");
    EXPECT_EQ(refusal([&] { return connect(recipe, "define.veins", "define.grain.input"); }),
              "that makes a circle: veins uses add uses grain uses veins; take another input");
    EXPECT_EQ(refusal([&] { return connect(recipe, "texture", "texture.input"); }),
              "that makes a circle: colour map uses colour map; take another input");
    EXPECT_NE(refusal([&] {
                  return move_node(recipe, "define.veins.input", "define.grain.input");
              }).find("add uses grain uses add"),
              std::string::npos);
    EXPECT_EQ(refusal([&] { return connect(recipe, "define.grain", "define.veins.input.b"); }), "");
}

/// The values of a base colour at some points.
std::vector<Vec3d> colors_of(const Recipe& recipe) {
    std::vector<Vec3d> colors;
    const GraphEvaluator evaluate(recipe.texture);
    for (int i = 0; i < 40; ++i)
        colors.push_back(evaluate(Vec3d(0.13 * i, -0.31 * i, 0.07 * i * i)).color());
    return colors;
}

TEST(BuildSteps, NamesChangeNoValue) {
    for (const char* preset : {"carved-wood", "cloudy-planet", "oak", "car-paint"}) {
        const Recipe recipe = load_recipe(preset);
        Recipe named = recipe;
        for (const char* place : {"texture", "texture.input", "texture.base"})
            if (refusal([&] { return name_node(named, place, "part"); }).empty()) {
                named = name_node(named, place, "part").recipe;
                break;
            }
        ASSERT_NE(named, recipe);
        EXPECT_EQ(colors_of(named), colors_of(recipe)) << preset;
        named = name_node(named, "define.part", "piece").recipe;
        EXPECT_EQ(colors_of(named), colors_of(recipe)) << preset;
        named = inline_name(named, "piece").recipe;
        EXPECT_EQ(colors_of(named), colors_of(recipe)) << preset;
        EXPECT_EQ(named, recipe) << preset;
    }
}

TEST(BuildSteps, AWrittenOutNameIsCopiedToAllThatUseIt) {
    const std::string fract = R"({"node": "fract", "input": {"node": "multiply",
        "a": 9, "b": {"node": "distance", "weights": [1, 1, 0]}}})";
    EXPECT_EQ(inline_name(recipe_with(rings), "rings").recipe,
              recipe_with(R"("texture": {"node": "color_map", "wrap": "clamp",
            "stops": [[0, "#a47747"], [1, "#c69d69"]], "input": )" +
                          fract + R"(},
        "material": {"roughness": {"node": "add", "a": 0.4, "b": )" +
                          fract + "}}"));
    EXPECT_NE(refusal([] { return inline_name(recipe_with(rings), "ring"); }), "");
    const Recipe loose = add_node(empty_recipe(), "", "fbm").recipe;
    EXPECT_NE(refusal([&] { return inline_name(loose, "fbm"); }), "");
}

TEST(BuildSteps, NamesAreChecked) {
    const Recipe recipe = recipe_with(rings);
    for (const char* name : {"", "#a", "a.b", "rings"})
        EXPECT_NE(refusal([&] { return name_node(recipe, "texture", name); }), "") << name;
    EXPECT_EQ(name_node(recipe, "texture.input", "years").recipe,
              name_node(recipe, "define.rings", "years").recipe);
}

TEST(BuildSteps, AGroupIsNamedByItsOneResult) {
    const Recipe recipe = recipe_with(R"("texture": {"node": "mix", "a": {"node": "marble"},
        "b": "#00ff00", "amount": {"node": "abs", "input": {"node": "fbm"}}})");
    const GraphEdit edit = group_nodes(recipe, {"texture.amount", "texture.amount.input"}, "veins");
    EXPECT_EQ(edit.recipe, name_node(recipe, "texture.amount", "veins").recipe);
    EXPECT_EQ(edit.words, "group veins");
    EXPECT_EQ(refusal([&] {
                  return group_nodes(recipe, {"texture.amount", "texture.a"}, "x");
              }),
              "these nodes have 2 results, marble, abs; a group has one");
    EXPECT_NE(refusal([&] { return group_nodes(recipe, {}, "x"); }), "");
}

TEST(BuildSteps, ChannelsComeAndGo) {
    const Recipe recipe = empty_recipe();
    const GraphEdit rough = add_channel(recipe, "roughness");
    EXPECT_EQ(rough.recipe, recipe_with(R"("texture": {"node": "constant", "value": "#808080"},
        "material": {"roughness": {"node": "constant", "value": 0.6}})"));
    EXPECT_EQ(remove_channel(rough.recipe, "roughness").recipe, recipe);
    const GraphEdit high = add_channel(recipe, "height");
    EXPECT_FALSE(high.recipe.bump.empty());
    EXPECT_EQ(remove_channel(high.recipe, "height").recipe, recipe);
    EXPECT_NE(refusal([&] { return add_channel(recipe, "ior"); }), "");
    EXPECT_NE(refusal([&] { return remove_channel(recipe, "roughness"); }), "");
}

TEST(BuildSteps, PaintAndEverythingElseStays) {
    Recipe recipe = load_recipe("oak");
    PaintStroke stroke;
    stroke.points = {{0.1, 0.2, 0.3}};
    recipe.paint = {stroke};
    const Recipe edited = add_node(recipe, "material.metallic", "fbm").recipe;
    EXPECT_EQ(edited.paint, recipe.paint);
    EXPECT_EQ(delete_nodes(edited, {"material.metallic"}).recipe, recipe);
}

TEST(BuildSteps, ANodeIsAddedAfterAnother) {
    const Recipe recipe = recipe_with(R"("texture": {"node": "mix", "a": "#ff0000",
        "b": "#0000ff", "amount": {"node": "fbm"}})");
    const GraphEdit edit = add_node_after(recipe, "texture.amount", "remap out_high=2");
    EXPECT_EQ(edit.recipe, recipe_with(R"("texture": {"node": "mix", "a": "#ff0000",
        "b": "#0000ff", "amount": "fbm"}, "define": {
        "remap": {"node": "remap", "input": "fbm", "out_high": 2}, "fbm": {"node": "fbm"}})"));
    EXPECT_EQ(edit.path, "define.remap");
    EXPECT_EQ(edit.words, "add remap after fbm");
    EXPECT_EQ(refusal([&] { return add_node_after(recipe, "texture.amount", "marble"); }),
              "marble has no input that is free; choose another node");
    EXPECT_NE(refusal([&] { return add_node_after(recipe, "texture.nothing", "abs"); }), "");
    // A colour where a number is wanted goes through its luminance, as when it is connected.
    EXPECT_EQ(refusal([&] { return add_node_after(recipe, "texture", "abs"); }), "");
}

TEST(BuildSteps, LayersOfPaintAreCounted) {
    Recipe recipe = recipe_with(R"("texture": {"node": "blend", "base": "#ff0000",
        "top": "#0000ff", "mask": {"node": "paint", "layer": 2}}, "bump": {"input":
        {"node": "paint", "layer": 5}})");
    recipe.paint.resize(2);
    recipe.paint[1].layer = 1;
    EXPECT_EQ(paint_layers(recipe), (std::vector<int>{1, 2, 5}));
    EXPECT_EQ(free_paint_layer(recipe), 3);
    EXPECT_EQ(free_paint_layer(recipe_with(R"("texture": {"node": "fbm"})")), 1);
}

}  // namespace
}  // namespace burl
