// The graph's window under pointer and keys, without a display.
#include <gtest/gtest.h>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/edit/clip.h"
#include "app/edit/look.h"
#include "app/pipeline/pipeline.h"
#include "tests/app/edit/edit_cases.h"
#include "tests/app/edit/oak_steps.h"
#include "tests/app/editor/window/fixture.h"
#include "tests/app/support/scratch_folder.h"
#include "tests/paths.h"

namespace burl {
namespace {

class GlEditGraph : public GlEditProgramTest {
  protected:
    /// The editor with its graph open on a recipe of these parts.
    std::unique_ptr<EditorProgram> start_with(const std::string& parts) {
        write_file(folder / "r.json", to_json(test::recipe_with(parts)));
        auto editor = start(folder / "r.json");
        play(*editor, R"({"key": "N"}, {"wait": 2})");
        return editor;
    }
    static std::string text_of(const std::string& path) {
        const auto bytes = read_file_bytes(path);
        return {bytes.begin(), bytes.end()};
    }
    /// The recipe of these parts as the editor has it.
    static Recipe wanted(const EditorProgram& editor, const std::string& parts) {
        Recipe recipe = test::recipe_with(parts);
        recipe.atlas = const_cast<EditorProgram&>(editor).session().recipe().atlas;
        return recipe;
    }

    const ScratchFolder folder;
};

const char* const mixed = R"("texture": {"node": "mix", "a": "#ff0000", "b": "#0000ff",
    "amount": {"node": "fbm", "octaves": 3}})";

TEST_F(GlEditGraph, OakIsBuiltFromNothingByItsScript) {
    const auto editor = start();
    play(*editor, R"({"resize": [1280, 800]}, {"wait": 2})");
    const Recipe like = editor->session().recipe();
    editor->play(
        parse_script(text_of(test::source_folder() + "/docs/images/editor-oak.json"), "oak"), "");
    const test::BuiltRecipe oak = test::built_oak(like);
    EXPECT_EQ(editor->session().recipe(), oak.recipe);
    EditHistory& history = editor->session().history();
    // The first step opened what was there, the second one is the new recipe.
    EXPECT_EQ(history.step(), std::size_t(oak.steps) + 1);
    EXPECT_EQ(history.words(history.step()), "connect pores to amount of mix");
    while (history.can_undo()) history.undo();
    EXPECT_EQ(history.recipe(), like);
}

TEST_F(GlEditGraph, ANodeIsAddedByItsNameAndDeleted) {
    const auto editor = start_with(mixed);
    const Recipe before = editor->session().recipe();
    play(*editor, R"({"click": "in:texture.b"}, {"key": "Tab"}, {"type": "marb"}, {"key": "Enter"},
                     {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": "#ff0000", "b": {"node": "marble"}, "amount": {"node": "fbm", "octaves": 3}})"));
    EXPECT_EQ(editor->graph().model().current(), "texture.b");
    play(*editor, R"({"key": "Delete"}, {"wait": 2}, {"key": "Ctrl+Z"}, {"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), before);
}

TEST_F(GlEditGraph, ANumberWhereAColourMayStandBecomesOne) {
    const auto editor =
        start_with(R"("texture": {"node": "blend", "top": 0.5, "base": "#112233"})");
    play(*editor, R"({"click": "in:texture.top"}, {"wait": 2}, {"click": "node colour"},
                     {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(),
              wanted(*editor, R"("texture": {"node": "blend", "top": "#bcbcbc",
                                 "base": "#112233"})"));
    EXPECT_FALSE(editor->items().find("node colour"));
}

TEST_F(GlEditGraph, TheSearchIsClickedToo) {
    const auto editor = start_with(mixed);
    play(*editor, R"({"double_click": "node:texture"}, {"wait": 2}, {"key": "Escape"},
                     {"click": "in:texture.a"}, {"key": "Space"}, {"type": "wood"}, {"wait": 2},
                     {"click": "graph found:wood_grain"}, {"wait": 2})");
    const auto& graph = editor->graph().model().graph();
    ASSERT_TRUE(graph.find("texture.a"));
    EXPECT_EQ(graph.nodes[*graph.find("texture.a")].type, "wood_grain");
}

TEST_F(GlEditGraph, WiresAreDrawnMovedAndCut) {
    const auto editor = start_with(mixed);
    play(*editor, R"({"drag": "out:texture.amount", "to": "in:texture.b"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": "#ff0000", "b": "fbm", "amount": "fbm"},
        "define": {"fbm": {"node": "fbm", "octaves": 3}})"));
    play(*editor, R"({"drag": "in:texture.amount", "to": "in:texture.a"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": "fbm", "b": "fbm", "amount": 0.5}, "define": {"fbm": {"node": "fbm", "octaves": 3}})"));
    play(*editor, R"({"drag": "in:texture.b", "by": [-30, 110]}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": "fbm", "b": 1, "amount": 0.5}, "define": {"fbm": {"node": "fbm", "octaves": 3}})"));
    EXPECT_EQ(editor->session().history().step(), 3u);
}

TEST_F(GlEditGraph, ACircleIsRefusedInTheLog) {
    const auto editor = start_with(R"("texture": {"node": "color_map", "input":
        {"node": "abs", "input": {"node": "add", "a": {"node": "fbm"}, "b": 0}}})");
    const Recipe before = editor->session().recipe();
    play(*editor,
         R"({"drag": "out:texture.input", "to": "in:texture.input.input.b"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), before);
    ASSERT_TRUE(editor->session().log().back().problem);
    EXPECT_EQ(editor->session().log().back().text,
              "that makes a circle: abs uses add uses abs; take another input");
}

TEST_F(GlEditGraph, AGroupGetsANameThatCanBeChanged) {
    const auto editor = start_with(mixed);
    play(*editor, R"({"key": "F"}, {"wait": 2}, {"click": "tree:texture.amount"}, {"wait": 2},
                     {"key": "Ctrl+G"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": "#ff0000", "b": "#0000ff", "amount": "group_1"},
        "define": {"group_1": {"node": "fbm", "octaves": 3}})"));
    play(*editor, R"({"click": "node name"}, {"key": "Ctrl+A"}, {"type": "grain"}, {"key": "Enter"},
                     {"wait": 2})");
    EXPECT_TRUE(editor->graph().model().graph().find("define.grain"));
}

TEST_F(GlEditGraph, NodesAreCopiedAndPastedAsJson) {
    const auto editor = start_with(mixed);
    play(*editor, R"({"click": "tree:texture.amount"}, {"wait": 2}, {"key": "Ctrl+C"},
                     {"click": "tree:texture.a"}, {"key": "Ctrl+V"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": {"node": "fbm", "octaves": 3}, "b": "#0000ff",
        "amount": {"node": "fbm", "octaves": 3}})"));
    play(*editor, R"({"click": "object"}, {"key": "Ctrl+C"}, {"key": "Ctrl+Z"}, {"key": "Ctrl+V"},
                     {"wait": 2})");
    EXPECT_EQ(editor->session().history().words(1), "other nodes") << "a whole recipe, as ever";
}

TEST_F(GlEditGraph, TheKeyboardAloneBuilds) {
    const auto editor = start_with(mixed);
    play(*editor, R"({"click": "tree:texture"}, {"wait": 2}, {"key": "Down"}, {"key": "Down"},
                     {"key": "Insert"}, {"type": "uv"}, {"key": "Enter"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": "#ff0000", "b": {"node": "uv"}, "amount": {"node": "fbm", "octaves": 3}})"));
    play(*editor, R"({"key": "Left"}, {"wait": 2}, {"key": "Left"}, {"wait": 2})");
    EXPECT_FALSE(editor->items().find("tree:texture.b")) << "folded away";
    play(*editor, R"({"key": "Right"}, {"wait": 2}, {"key": "Right"}, {"key": "Delete"},
                     {"wait": 2})");
    EXPECT_TRUE(editor->items().find("tree:texture.b"));
}

TEST_F(GlEditGraph, ANodeIsLookedAtAloneUntilEscape) {
    const auto editor = start_with(mixed);
    const Image<Rgb8> before = settled(*editor);
    const Recipe recipe = editor->session().recipe();
    play(*editor, R"({"click": "tree:texture.amount"}, {"wait": 2}, {"key": "Enter"}, {"wait": 2},
                     {"settle": true})");
    EXPECT_EQ(editor->requests().looking_at(), "texture.amount");
    EXPECT_EQ(editor->requests().last_recipe(), look_at(recipe, "texture.amount").recipe);
    EXPECT_LT((*editor->requests().look_range())[0], 0.0) << "noise about 0";
    EXPECT_TRUE(editor->items().find("look badge"));
    EXPECT_FALSE(editor->session().history().can_undo()) << "no edit";
    play(*editor, R"({"key": "Escape"}, {"wait": 2})");
    EXPECT_EQ(editor->requests().looking_at(), "");
    EXPECT_FALSE(editor->items().find("look badge"));
    play(*editor, R"({"key": "Enter"}, {"wait": 2}, {"key": "Delete"}, {"wait": 2})");
    EXPECT_EQ(editor->requests().looking_at(), "") << "the node is gone";
}

TEST_F(GlEditGraph, TheChosenNodesParametersAreBesideIt) {
    const auto editor = start_with(mixed);
    play(*editor, R"({"click": "tree:texture.amount"}, {"wait": 3},
                     {"drag": "texture.amount.octaves", "by": [60, 0]}, {"wait": 2})");
    EXPECT_GT(editor->session().recipe().texture.nodes[3].parameters.size(), 2u);
    const auto& graph = editor->graph().model().graph();
    EXPECT_GT(graph.nodes[*graph.find("texture.amount")].json["octaves"].get<int>(), 3);
    EXPECT_EQ(editor->session().history().step(), 1u);
}

TEST_F(GlEditGraph, TermsOfAFieldComeGoAndChangePlaces) {
    const auto editor = start();
    play(*editor, R"({"key": "N"}, {"wait": 2}, {"click": "tree:texture.input"}, {"wait": 3},
                     {"click": "term add"}, {"wait": 2})");
    const auto terms = [&] { return plain_texture(editor->session().recipe().texture)->noise; };
    ASSERT_EQ(terms().size(), 2u);
    const auto before = terms();
    EXPECT_NE(before[0].seed, before[1].seed);
    play(*editor, R"({"click": "term:texture.input.noise.1"}, {"wait": 2},
                     {"click": "term up:texture.input.noise.1"}, {"wait": 2})");
    EXPECT_EQ(terms()[0].seed, before[1].seed);
    play(*editor, R"({"click": "term remove:texture.input.noise.1"}, {"wait": 2})");
    EXPECT_EQ(terms().size(), 1u);
}

TEST_F(GlEditGraph, StepsAreListedAndAClickGoesThere) {
    const auto editor = start_with(mixed);
    const Recipe first = editor->session().recipe();
    play(*editor, R"({"click": "in:texture.a"}, {"key": "Insert"}, {"type": "uv"}, {"key": "Enter"},
                     {"wait": 2}, {"click": "in:texture.b"}, {"key": "Insert"}, {"type": "marble"},
                     {"key": "Enter"}, {"wait": 2}, {"click": "tab:Steps"}, {"wait": 2})");
    const Recipe last = editor->session().recipe();
    const EditHistory& history = editor->session().history();
    ASSERT_EQ(history.step_count(), 3u);
    EXPECT_EQ(history.words(0), "open r.json");
    EXPECT_EQ(history.words(1), "add uv");
    EXPECT_EQ(history.words(2), "add marble");
    play(*editor, R"({"click": "step:0"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), first);
    play(*editor, R"({"click": "step:2"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), last);
}

TEST_F(GlEditGraph, TwoKeptStatesFollowOneAnother) {
    const auto editor = start_with(mixed);
    const Recipe first = editor->session().recipe();
    const auto shown = [&] { return editor->requests().last_recipe(); };
    play(*editor, R"({"key": "Shift+A"}, {"click": "in:texture.a"}, {"key": "Insert"},
                     {"type": "uv"}, {"key": "Enter"}, {"wait": 2}, {"key": "Shift+B"})");
    const Recipe second = editor->session().recipe();
    play(*editor, R"({"click": "in:texture.b"}, {"key": "Insert"}, {"type": "marble"},
                     {"key": "Enter"}, {"wait": 2})");
    const Recipe third = editor->session().recipe();
    play(*editor, R"({"key": "A"}, {"wait": 4})");
    EXPECT_EQ(shown(), first);
    play(*editor, R"({"key": "A"}, {"wait": 4})");
    EXPECT_EQ(shown(), second);
    play(*editor, R"({"key": "A"}, {"wait": 4})");
    EXPECT_EQ(shown(), third);
    play(*editor, R"({"click": "tab:Steps"}, {"wait": 2}, {"click": "back to:A"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), first);
    EXPECT_EQ(editor->session().history().words(editor->session().history().step()),
              "go back to A");
}

TEST_F(GlEditGraph, ThePlaneIsMovedAndEnlarged) {
    const auto editor = start_with(mixed);
    const GraphCamera before = editor->graph().model().camera;
    play(*editor, R"({"wheel": "graph", "by": [0, 2]}, {"wait": 1})");
    EXPECT_GT(editor->graph().model().camera.zoom, before.zoom);
    const Vec2d offset = editor->graph().model().camera.offset;
    play(*editor, R"({"events": [{"move": [300, 560]}]}, {"events": [{"button": 2, "down": true}]},
                     {"events": [{"move": [340, 540]}]}, {"events": [{"button": 2, "down": false}]})");
    EXPECT_LT(editor->graph().model().camera.offset.x, offset.x);
    EXPECT_GT(editor->graph().model().camera.offset.y, offset.y);
    EXPECT_FALSE(editor->session().history().can_undo());
}

TEST_F(GlEditGraph, AWireDroppedBesideAllNodesAsksForTheNodeBehindIt) {
    const auto editor = start_with(mixed);
    const Recipe before = editor->session().recipe();
    // From a node's output: the new node goes on with it.
    play(*editor, R"({"drag": "out:texture.amount", "by": [20, 95]}, {"wait": 2})");
    ASSERT_TRUE(editor->graph().searching());
    EXPECT_FALSE(editor->items().find("graph found:fbm")) << "takes nothing";
    play(*editor, R"({"type": "smoothst"}, {"key": "Enter"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": "#ff0000", "b": "#0000ff", "amount": "fbm"}, "define":
        {"smoothstep": {"node": "smoothstep", "input": "fbm", "low": 0, "high": 1},
         "fbm": {"node": "fbm", "octaves": 3}})"));
    EXPECT_EQ(editor->session().history().step(), 1u) << "one step";
    EXPECT_EQ(editor->graph().model().current(), "define.smoothstep");
    play(*editor, R"({"key": "Ctrl+Z"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), before);
    // From an empty input: the new node stands there.
    play(*editor, R"({"drag": "in:texture.a", "by": [-30, 110]}, {"wait": 2}, {"type": "marble"},
                     {"key": "Enter"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), wanted(*editor, R"("texture": {"node": "mix",
        "a": {"node": "marble"}, "b": "#0000ff", "amount": {"node": "fbm", "octaves": 3}})"));
    // Escape leaves all as it was.
    play(*editor, R"({"drag": "out:texture.amount", "by": [20, 95]}, {"wait": 2},
                     {"key": "Escape"}, {"wait": 2})");
    EXPECT_FALSE(editor->graph().searching());
    EXPECT_EQ(editor->session().history().step(), 1u);
}

TEST_F(GlEditGraph, ALayersMaskIsPaintedOnTheObject) {
    const auto editor = start_with(R"("texture": {"node": "blend", "base": "#204080",
        "top": "#ffffff"})");
    const Image<Rgb8> before = settled(*editor);
    play(*editor,
         R"({"click": "tree:texture"}, {"wait": 3}, {"click": "node paint"}, {"wait": 3})");
    const auto& graph = editor->graph().model().graph();
    ASSERT_TRUE(graph.find("texture.mask"));
    EXPECT_EQ(graph.nodes[*graph.find("texture.mask")].json["layer"], 1);
    EXPECT_GT(different(*editor, before), 1000u) << "a mask without paint hides the layer";
    const Image<Rgb8> bare = settled(*editor);
    play(*editor, R"({"key": "N"}, {"wait": 3}, {"drag": "object", "by": [90, 20], "frames": 6},
                     {"wait": 2}, {"settle": true}, {"wait": 2})");
    const Recipe& recipe = editor->session().recipe();
    ASSERT_FALSE(recipe.paint.empty());
    EXPECT_EQ(recipe.paint[0].layer, 1);
    EXPECT_EQ(editor->session().history().step(), 2u);
    EXPECT_GT(different(*editor, bare), 200u);
    Pipeline pipeline(load_mesh("sample:cube"));
    pipeline.set_recipe(recipe);
    EXPECT_EQ(editor->baker().front().picture()->texels, pipeline.synthesize<Rgb8>());
    // Another node begins a mask of its own; the brush's window goes back to the first.
    play(
        *editor,
        R"({"key": "N"}, {"wait": 3}, {"click": "tree:texture.top"}, {"key": "Insert"}, {"type": "paint"},
                     {"key": "Enter"}, {"wait": 3})");
    EXPECT_EQ(graph.nodes[*graph.find(editor->graph().model().current())].json["layer"], 2);
    play(*editor, R"({"click": "node paint"}, {"wait": 3})");
    EXPECT_EQ(editor->paint_tool().brush.layer, 2);
    play(*editor, R"({"click": "paint.into"}, {"wait": 2}, {"click": "paint.into=1"}, {"wait": 2},
                     {"click": "paint.clear"}, {"wait": 2})");
    EXPECT_TRUE(editor->session().recipe().paint.empty());
}

}  // namespace
}  // namespace burl
