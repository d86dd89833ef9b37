// The timeline as a person uses it, without a display.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/file_bytes.h"
#include "app/editor/jobs/export.h"
#include "app/recipe/edit/key_edit.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "tests/app/editor/window/fixture.h"
#include "tests/app/support/scratch_folder.h"
#include "tests/paths.h"

namespace burl {
namespace {

const std::string amplitude = "texture.input.noise.0.amplitude";

TEST_F(GlEditProgramTest, KeysAreSetWithTwoMovesOfASlider) {
    const auto editor = start();
    const Recipe before = editor->session().recipe();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2}, {"key": "K"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [-4, 0]}, {"click": "timeline.key"})");
    ASSERT_EQ(editor->session().touched(), amplitude);
    ASSERT_EQ(editor->session().recipe().animation.tracks.size(), 1u);
    play(*editor, R"({"drag": "timeline.ruler", "by": [120, 0]}, {"wait": 2})");
    const double time = editor->session().time();
    EXPECT_GT(time, 1.0);
    play(*editor, R"({"drag": "texture.input.noise.0.amplitude", "by": [25, 0]})");
    const KeyTrack track = editor->session().recipe().animation.tracks.at(0);
    ASSERT_EQ(track.keys.size(), 2u);
    EXPECT_EQ(track.keys[1].seconds, time);
    EXPECT_GT(track.keys[1].value, track.keys[0].value);
    EXPECT_EQ(plain_texture(editor->session().still().texture)->noise[0].amplitude,
              track.keys[1].value);
    play(*editor, R"({"key": "Ctrl+Z"}, {"key": "Ctrl+Z"}, {"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), before);
}

TEST_F(GlEditProgramTest, PlayingMovesThePictureAndIsNoEdit) {
    const auto editor = start("forming-marble");
    const Image<Rgb8> before = settled(*editor);
    play(*editor,
         R"({"key": "K"}, {"wait": 2}, {"key": "Space"}, {"wait": 120}, {"key": "Space"})");
    EXPECT_GT(editor->session().time(), 1.5);
    EXPECT_LT(editor->session().time(), 2.5);
    EXPECT_GT(different(*editor, before), 3000u);
    EXPECT_EQ(editor->baker().front().picture()->level, 0u);  // fine again once it rests
    EXPECT_FALSE(editor->session().history().can_undo());
    EXPECT_FALSE(editor->session().history().changed());
}

TEST_F(GlEditProgramTest, DiamondsAreMovedAndTakenAway) {
    const auto editor = start("forming-marble");
    const Recipe before = editor->session().recipe();
    const std::string key = "timeline.key:" + amplitude + ".1";
    play(*editor, R"({"key": "K"}, {"wait": 2}, {"drag": ")" + key + R"(", "by": [-60, 0]})");
    const KeyTrack* moved = find_track(editor->session().recipe().animation, amplitude);
    EXPECT_LT(moved->keys[1].seconds, 3.0);
    EXPECT_EQ(moved->keys[1].value, 0.5);
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), before);
    play(*editor, R"({"wait": 2}, {"click": ")" + key + R"("}, {"key": "Delete"})");
    EXPECT_EQ(find_track(editor->session().recipe().animation, amplitude)->keys.size(), 1u);
    EXPECT_EQ(editor->session().time(), 3.0);  // where the key was
}

/// Moving the texture sets keys of what has some; taken back it leaves none.
TEST_F(GlEditProgramTest, EscapeTakesTheKeysOfAMoveAway) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2}, {"key": "K"}, {"wait": 2},
        {"drag": "solid.translate.0", "by": [4, 0]}, {"key": "I"}, {"wait": 2})");
    const Recipe before = editor->session().recipe();
    ASSERT_EQ(before.animation.tracks.at(0).keys.size(), 1u);
    editor->session().set_time(1.0);
    const auto object = [&] { return editor->items().find("object")->middle(); };
    play(*editor, R"({"key": "G"}, {"wait": 2}, {"click": "move.axes"}, {"wait": 2})");
    const glm::dvec2 at = object();
    play(*editor, fmt::format(R"({{"events": [{{"move": [{0}, {1}]}}]}},
        {{"events": [{{"button": 0, "down": true}}]}}, {{"events": [{{"move": [{2}, {1}]}}]}},
        {{"wait": 2}})",
                              at.x, at.y, at.x + 30.0));
    ASSERT_EQ(editor->session().recipe().animation.tracks.at(0).keys.size(), 2u);
    play(*editor, R"({"key": "Escape"}, {"events": [{"button": 0, "down": false}]}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), before);
}

/// The number under the hand was one of windy, and checks has a colour where its node was.
TEST_F(GlEditProgramTest, ATimelineOfAnotherRecipeForgetsTheNumberTouched) {
    const auto bytes = read_file_bytes(test::case_file("editor-stoi.json"));
    const auto editor = start();
    play(*editor, R"({"resize": [1280, 800]}, {"wait": 3})");
    editor->play(parse_script({bytes.begin(), bytes.end()}, "editor-stoi.json"), "");
    EXPECT_EQ(editor->session().recipe(), load_recipe("checks"));
    EXPECT_TRUE(editor->items().find("timeline.number"));
    EXPECT_EQ(editor->session().touched(), "");
}

TEST_F(GlEditProgramTest, ExportsAreOfWhatIsSeenAndFramesOfAllTimes) {
    const ScratchFolder folder;
    Recipe recipe =
        load_recipe("forming-marble", {"atlas.size=32", "atlas.tries=1", "animation.rate=1"});
    bake_frames({"sample:cube", recipe, folder / "f.png"});
    ASSERT_EQ(frame_count(recipe.animation), 5);
    for (int i = 0; i < 5; ++i) {
        bake_file({"sample:cube", recipe_at(recipe, i), folder / "s.png"});
        EXPECT_EQ(read_file_bytes(folder / fmt::format("f.000{}.png", i + 1)),
                  read_file_bytes(folder / "s.png"))
            << i;
    }
    EXPECT_THROW(bake_frames({"sample:cube", recipe, folder / "f.glb"}), Error);
    EXPECT_EQ(bake_options({"sample:cube", recipe, "f.png"}),
              (std::vector<std::string>{"-o", "f.png", "--frames", "5"}));
}

}  // namespace
}  // namespace burl
