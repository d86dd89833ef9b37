// The parts of the window: they cover it, follow the splitters, and are found again.
#include "app/editor/window/panes.h"

#include <gtest/gtest.h>

#include "tests/app/editor/window/files_fixture.h"

namespace burl {
namespace {

float area(const ScreenRect& rect) {
    return rect.empty() ? 0.0f : (rect.high.x - rect.low.x) * (rect.high.y - rect.low.y);
}

TEST(Panes, CoverTheWindowWithoutOverlapAtAnySizeAndShare) {
    for (const ImVec2& size : {ImVec2(1280, 800), ImVec2(300, 900), ImVec2(64, 202)})
        for (const double share : {0.0, 0.05, 0.4, 0.95})
            for (const bool atlas : {false, true})
                for (const float timeline : {0.0f, 120.0f}) {
                    const Panes panes = panes_of({size, 25.0f, 25.0f, atlas, timeline},
                                                 {share, share == 0.0 ? 0.5 : share, share});
                    const float whole = area(panes.tools) + area(panes.object) + area(panes.atlas) +
                                        area(panes.timeline) + area(panes.side);
                    EXPECT_NEAR(whole, size.x * (size.y - 25.0f), 1.0f);
                    for (const ScreenRect& rect : {panes.object, panes.side}) {
                        EXPECT_FALSE(rect.empty()) << size.x << ' ' << share;
                        EXPECT_GE(rect.low.x, 0.0f);
                        EXPECT_LE(rect.high.x, size.x);
                        EXPECT_LE(rect.high.y, size.y);
                    }
                    EXPECT_EQ(panes.atlas.empty(), !atlas);
                    EXPECT_EQ(panes.timeline.empty(), timeline == 0.0f);
                }
}

TEST(Panes, HaveTheSharesAskedFor) {
    const Panes panes = panes_of({{1000, 1025}, 25.0f, 25.0f, true, 100.0f}, {0.25, 0.75, 0.2});
    EXPECT_NEAR(panes.side.high.x - panes.side.low.x, 250.0f, 1.0f);
    EXPECT_NEAR(panes.timeline.high.y - panes.timeline.low.y, 205.0f, 1.0f);
    EXPECT_NEAR(panes.atlas.high.x - panes.atlas.low.x, 0.75f * 750.0f, 1.0f);
    EXPECT_TRUE(panes.beside);
    EXPECT_FALSE(panes_of({{600, 2000}, 25.0f, 25.0f, true, 0.0f}, {}).beside);
}

class GlEditPanesTest : public GlEditFilesTest {
  protected:
    std::unique_ptr<EditorProgram> open_kept() {
        EditorOptions options;
        options.mesh = "sample:cube";
        options.settings = {"atlas.size=64", "atlas.tries=1"};
        options.recipe = "marble";
        options.gallery = false;
        options.preferences = folder / "preferences.json";
        auto editor = std::make_unique<EditorProgram>(
            create_unseen_window(create_test_context(), {800, 640}), options);
        play(*editor, settle);
        return editor;
    }
    static double width(const EditorProgram& editor, const char* item) {
        const ItemRect rect = editor.items().find(item).value();
        return rect.high.x - rect.low.x;
    }
};

TEST_F(GlEditPanesTest, SplittersMoveGoBackAndAreKept) {
    auto editor = open_kept();
    const double usual = width(*editor, "object");
    play(*editor, R"({"drag": "splitter:side", "by": [-60, 0]}, {"wait": 3})");
    EXPECT_NEAR(width(*editor, "object"), usual - 60.0, 2.0);
    play(*editor, R"({"key": "V"}, {"key": "K"}, {"wait": 3})");
    const double half = width(*editor, "object");
    const double height = editor->items().find("object")->high.y;
    play(*editor, R"({"drag": "splitter:atlas", "by": [40, 0]},
                     {"drag": "splitter:timeline", "by": [0, -50]}, {"wait": 3})");
    EXPECT_NEAR(width(*editor, "object"), half + 40.0, 2.0);
    EXPECT_NEAR(editor->items().find("object")->high.y, height - 50.0, 2.0);
    editor.reset();  // ImGui has one context at a time
    const auto next = open_kept();
    EXPECT_NEAR(width(*next, "object"), usual - 60.0, 2.0);
    play(*next, R"({"wait": 30}, {"double_click": "splitter:side"}, {"wait": 3})");
    EXPECT_EQ(width(*next, "object"), usual);
    play(*next, R"({"drag": "splitter:side", "by": [-60, 0]}, {"click": "menu:View"}, {"wait": 3},
                   {"click": "menu:Panels where they were at first"}, {"wait": 3})");
    EXPECT_EQ(width(*next, "object"), usual);
}

TEST_F(GlEditPanesTest, TheGraphsBorderIsKept) {
    auto editor = open_kept();
    play(*editor, R"({"click": "close first steps"}, {"wait": 3}, {"key": "N"}, {"wait": 3})");
    const double usual = editor->items().find("graph border")->low.y;
    play(*editor, R"({"drag": "graph border", "by": [0, -60]}, {"wait": 3})");
    const double moved = editor->items().find("graph border")->low.y;
    EXPECT_NEAR(moved, usual - 60.0, 8.0);
    editor.reset();  // ImGui has one context at a time
    const auto next = open_kept();
    play(*next, R"({"wait": 30}, {"key": "N"}, {"wait": 3})");
    EXPECT_NEAR(next->items().find("graph border")->low.y, moved, 1.0);
    play(*next, R"({"click": "menu:View"}, {"wait": 3},
                   {"click": "menu:Panels where they were at first"}, {"wait": 3})");
    EXPECT_EQ(next->items().find("graph border")->low.y, usual);
}

TEST_F(GlEditPanesTest, TheLightThemeIsKept) {
    auto editor = open_kept();
    play(*editor, R"({"click": "close first steps"}, {"wait": 3})");
    const auto side = [](EditorProgram& shown) { return shown.screenshot()(780, 600); };
    const Rgb8 dark = side(*editor);
    play(*editor, R"({"click": "menu:View"}, {"wait": 3}, {"click": "menu:Light theme"},
                     {"wait": 3})");
    EXPECT_LT(int(dark.r), 80);
    const Rgb8 light = side(*editor);
    EXPECT_GT(int(light.r), 180);
    editor.reset();
    EXPECT_EQ(side(*open_kept()), light);
}

TEST_F(GlEditPanesTest, FirstStepsAreTickedAndNotShownAgain) {
    auto editor = open_kept();
    ASSERT_TRUE(editor->items().find("close first steps")) << "a first start";
    play(*editor, R"({"drag": "object", "by": [20, 5]}, {"wait": 3})");
    play(*editor, R"({"click": "close first steps"}, {"wait": 3})");
    EXPECT_FALSE(editor->items().find("close first steps"));
    editor.reset();  // ImGui has one context at a time
    const auto next = open_kept();
    EXPECT_FALSE(next->items().find("close first steps"));
    play(*next, R"({"click": "menu:Help"}, {"wait": 3}, {"click": "menu:First steps"},
                   {"wait": 3})");
    EXPECT_TRUE(next->items().find("close first steps"));
}

TEST_F(GlEditPanesTest, EscapeClosesTheListOfKeysAlone) {
    const auto editor = open_kept();
    play(*editor, R"({"resize": [1400, 1000]}, {"wait": 2}, {"key": "F1"}, {"wait": 3})");
    EXPECT_TRUE(editor->items().find("close keys"));
    play(*editor, R"({"key": "Ctrl+O"}, {"wait": 3}, {"key": "Escape"}, {"wait": 3})");
    EXPECT_TRUE(editor->items().find("close keys")) << "the dialog takes the first";
    play(*editor, R"({"key": "Escape"}, {"wait": 3})");
    EXPECT_FALSE(editor->items().find("close keys"));
}

TEST_F(GlEditPanesTest, FavouritesAreStarredAndKept) {
    auto editor = open_kept();
    const Recipe before = editor->session().recipe();
    play(*editor, R"({"click": "favourite:birch"}, {"wait": 3})");
    EXPECT_EQ(editor->preferences().favourites, std::set<std::string>{"birch"});
    EXPECT_EQ(editor->session().recipe(), before) << "a star opens nothing";
    editor.reset();  // ImGui has one context at a time
    const auto next = open_kept();
    play(*next, R"({"click": "library favourites"}, {"wait": 3})");
    EXPECT_TRUE(next->items().find("preset:birch"));
    EXPECT_FALSE(next->items().find("preset:cherry"));
    play(*next, R"({"click": "favourite:birch"}, {"wait": 3})");
    EXPECT_FALSE(next->items().find("preset:birch"));
    play(*next, R"({"click": "library favourites"}, {"wait": 3}, {"click": "category:metal"},
                   {"wait": 3})");
    EXPECT_TRUE(next->items().find("preset:gold"));
    EXPECT_FALSE(next->items().find("preset:birch"));
}

}  // namespace
}  // namespace burl
