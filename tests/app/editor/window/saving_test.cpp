// What an editor saves, where to, and what it asks before anything is lost.
#include <gtest/gtest.h>

#include <filesystem>

#include "app/recipe/edit/recipe_json.h"
#include "tests/app/editor/window/files_fixture.h"

namespace burl {
namespace {

class GlEditSavingTest : public GlEditFilesTest {};

TEST_F(GlEditSavingTest, WhatItSavesItselfIsNoNews) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [30, 0]}, {"key": "Ctrl+S"}, {"wait": 2})");
    EXPECT_EQ(load_recipe(folder / "r.json"), editor->session().recipe());
    const std::size_t lines = editor->session().log().size();
    play(*editor, settle);
    EXPECT_EQ(editor->session().log().size(), lines);
    play(*editor, R"({"key": "Ctrl+Z"}, {"settle": true})");
    EXPECT_TRUE(editor->session().history().changed());
}

constexpr const char* drag_amplitude = R"({"click": "tab:Parameters"}, {"wait": 2},
    {"drag": "texture.input.noise.0.amplitude", "by": [30, 0]}, {"settle": true})";

TEST_F(GlEditSavingTest, WhatIsUndoneToIsSavedWhereItBelongs) {
    save("marble");
    save("wood", "solid.scale=1", "theirs.json");
    const std::string theirs = text("theirs.json");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, dropped(folder / "theirs.json"));
    EXPECT_EQ(editor->title(), "wood on sample:cube - Burl");
    play(*editor, R"({"key": "Ctrl+Z"}, {"wait": 2})");
    EXPECT_EQ(editor->files().recipe(), folder / "r.json");
    play(*editor, std::string(drag_amplitude) + R"(, {"key": "Ctrl+S"}, {"wait": 2})");
    EXPECT_EQ(text("theirs.json"), theirs);
    EXPECT_EQ(load_recipe(folder / "r.json"), editor->session().recipe());
}

TEST_F(GlEditSavingTest, APresetIsComparedWithAsLongAsItIsOpen) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    const Image<Rgb8> marble = settled(*editor);
    save("checks", "solid.scale=1", "c.json");
    play(*editor, dropped(folder / "c.json"));
    play(*editor, R"({"key": "Ctrl+Z"}, {"settle": true}, {"key": "A"}, {"settle": true})");
    const Image<Rgb8> compared = settled(*editor);
    std::size_t other = 0;
    for (std::size_t y = 60; y < 500; ++y)  // without the menu, which says what is shown
        for (std::size_t x = 0; x < 500; ++x) other += marble(x, y) == compared(x, y) ? 0 : 1;
    EXPECT_EQ(other, 0u);
}

TEST_F(GlEditSavingTest, AClickOnAPresetSavesNothing) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, drag_amplitude);
    const Recipe edited = editor->session().recipe();
    play(
        *editor,
        R"({"click": "tab:Library"}, {"wait": 2}, {"click": "category:classic"}, {"wait": 2}, {"click": "preset:sine-marble"},
        {"wait": 200}, {"key": "Ctrl+Q"}, {"wait": 2})");
    ASSERT_EQ(editor->session().recipe(), load_recipe("sine-marble"));
    EXPECT_EQ(editor->title(), "sine-marble * on sample:cube - Burl");
    ASSERT_TRUE(std::filesystem::exists(folder / "autosave.json"));
    EXPECT_EQ(load_recipe(folder / "autosave.json"), edited);
    EXPECT_FALSE(editor->wants_to_close());
    play(*editor, R"({"click": "Save it"}, {"wait": 2})");
    EXPECT_EQ(load_recipe(folder / "r.json"), edited);
    EXPECT_TRUE(editor->wants_to_close());
}

TEST_F(GlEditSavingTest, QuittingAsksForEverythingThatIsNotSaved) {
    save("marble");
    save("marble", "solid.scale=2", "s.json");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, drag_amplitude);
    const Recipe first = editor->session().recipe();
    play(*editor, dropped(folder / "s.json"));
    play(*editor, drag_amplitude);
    const Recipe second = editor->session().recipe();
    play(*editor, R"({"key": "Ctrl+Q"}, {"wait": 2}, {"click": "Save it"}, {"wait": 2})");
    EXPECT_EQ(load_recipe(folder / "s.json"), second);
    EXPECT_FALSE(editor->wants_to_close());
    ASSERT_TRUE(editor->items().find("Save it")) << "r.json is not saved";
    play(*editor, R"({"click": "Save it"}, {"wait": 2})");
    EXPECT_EQ(load_recipe(folder / "r.json"), first);
    EXPECT_TRUE(editor->wants_to_close());
}

TEST_F(GlEditSavingTest, QuittingWaitsForTheNameToSaveBy) {
    const auto editor = open("sample:cube", "marble");
    play(*editor, drag_amplitude);
    play(*editor, R"({"key": "Ctrl+Q"}, {"wait": 2}, {"click": "Save it"}, {"wait": 3})");
    ASSERT_TRUE(editor->items().find("file name"));
    EXPECT_FALSE(editor->items().find("Save it"));
    play(*editor, R"({"click": "file cancel"}, {"wait": 3})");
    EXPECT_FALSE(editor->wants_to_close());
    ASSERT_TRUE(editor->items().find("Save it")) << "it was not saved";
    play(*editor, R"({"click": "Save it"}, {"wait": 3}, {"type": ")" + (folder / "missing/r") +
                      R"("}, {"wait": 2}, {"key": "Enter"}, {"wait": 3})");
    EXPECT_FALSE(editor->wants_to_close());
    ASSERT_TRUE(editor->items().find("Save it")) << "it could not be saved";
    play(*editor, R"({"click": "Save it"}, {"wait": 3}, {"type": ")" + (folder / "r") +
                      R"("}, {"wait": 2}, {"key": "Enter"}, {"wait": 3})");
    EXPECT_TRUE(editor->wants_to_close());
    EXPECT_EQ(load_recipe(folder / "r.burl.json"), editor->session().recipe());
}

TEST_F(GlEditSavingTest, AFileThatWasKeptFromIsNotWhatIsSaved) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, drag_amplitude);
    save("wood");
    play(*editor, settle);
    play(*editor, R"({"click": "Keep this one"}, {"wait": 2}, {"key": "Ctrl+Z"}, {"wait": 2})");
    EXPECT_EQ(editor->title(), "marble * on sample:cube - Burl");
}

TEST_F(GlEditSavingTest, SavesUnderAnotherNameFromTheMenu) {
    save("marble");
    const std::string before = text("r.json");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, drag_amplitude);
    play(*editor, R"({"click": "menu:File"}, {"wait": 2}, {"click": "menu:Save recipe as..."},
        {"wait": 3}, {"type": ")" +
                      (folder / "other") + R"("}, {"wait": 2}, {"key": "Enter"},
        {"wait": 2})");
    EXPECT_EQ(text("r.json"), before);
    EXPECT_EQ(load_recipe(folder / "other.burl.json"), editor->session().recipe());
    EXPECT_EQ(editor->files().recipe(), folder / "other.burl.json");
}

}  // namespace
}  // namespace burl
