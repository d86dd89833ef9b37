// The editor as a person uses it, without a display: scripts of real pointer and key events, and
// what comes of them in the recipe, on the screen and on disk.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <filesystem>

#include "app/base/file_bytes.h"
#include "app/editor/jobs/export.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/scene/shading.h"
#include "atlas/base/error.h"
#include "tests/app/editor/window/fixture.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

TEST_F(GlEditProgramTest, ShowsTheObjectWithItsTexture) {
    const auto editor = start();
    const Image<Rgb8> screen = settled(*editor);
    std::size_t background = 0, other = 0;
    for (std::size_t y = 40; y < 480; ++y)
        for (std::size_t x = 10; x < 500; ++x)
            ++(screen(x, y) == background_srgb ? background : other);
    EXPECT_GT(background, 40000u);
    EXPECT_GT(other, 20000u);
    ASSERT_TRUE(editor->baker().front().picture());
    EXPECT_EQ(editor->baker().front().picture()->level, 0u);
}

TEST_F(GlEditProgramTest, ADragOfASliderIsOneStepThatUndoTakesBack) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2})");
    const Image<Rgb8> before = settled(*editor);
    const Recipe recipe = editor->session().recipe();
    play(*editor, R"({"drag": "texture.input.noise.0.amplitude", "by": [30, 0]})");
    EXPECT_GT(plain_texture(editor->session().recipe().texture)->noise.front().amplitude,
              plain_texture(recipe.texture)->noise.front().amplitude);
    EXPECT_GT(different(*editor, before), 3000u);
    play(*editor, R"({"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), recipe);
    EXPECT_FALSE(editor->session().history().can_undo());
    EXPECT_EQ(different(*editor, before), 0u);
}

TEST_F(GlEditProgramTest, SlidersTakeTypedNumbersAndGoBackToTheirDefault) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"events": [{"key": "Ctrl", "down": true}]}, {"click": "solid.scale"},
        {"events": [{"key": "Ctrl", "down": false}]}, {"type": "2.5"}, {"key": "Enter"})");
    EXPECT_EQ(editor->session().recipe().solid.scale, 2.5);
    play(*editor, R"({"wait": 30}, {"double_click": "solid.scale"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe().solid.scale, load_recipe("marble").solid.scale);
}

TEST_F(GlEditProgramTest, StopsAreAddedMovedAndDeleted) {
    const auto editor = start();
    const Recipe recipe = editor->session().recipe();
    const std::size_t stops = plain_texture(recipe.texture)->colors.stops.size();
    play(*editor,
         R"({"click": "tab:Colours"}, {"wait": 2}, {"click": "texture.bar"}, {"wait": 2})");
    EXPECT_EQ(plain_texture(editor->session().recipe().texture)->colors.stops.size(), stops + 1);
    const auto at = plain_texture(editor->session().recipe().texture)->colors.stops[1].position;
    play(*editor, R"({"drag": "texture.stops.1", "by": [-12, 0]})");
    EXPECT_LT(plain_texture(editor->session().recipe().texture)->colors.stops[1].position, at);
    play(*editor, R"({"wait": 2}, {"click": "texture.delete"})");
    EXPECT_EQ(plain_texture(editor->session().recipe().texture)->colors.stops.size(), stops);
    play(*editor, R"({"key": "Ctrl+Z"}, {"key": "Ctrl+Z"}, {"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->session().recipe(), recipe);
}

TEST_F(GlEditProgramTest, TheCameraMovesAndTheRecipeStays) {
    const auto editor = start();
    const Image<Rgb8> before = settled(*editor);
    const EditCamera camera = editor->camera();
    play(*editor, R"({"drag": "object", "by": [80, 30]})");
    EXPECT_NE(editor->camera().view.azimuth_degrees, camera.view.azimuth_degrees);
    EXPECT_GT(different(*editor, before), 3000u);
    const auto runs = editor->baker().front().records()[Stage::synthesis].runs;
    play(*editor, R"({"wheel": "object", "by": [0, 2]}, {"key": "1"}, {"key": "F"})");
    EXPECT_EQ(editor->camera().view.azimuth_degrees, 0.0);
    EXPECT_EQ(editor->baker().front().records()[Stage::synthesis].runs, runs);
    EXPECT_FALSE(editor->session().history().can_undo());
}

TEST_F(GlEditProgramTest, OpensWhatIsDroppedAndSaysWhatItCannotOpen) {
    const ScratchFolder folder;
    const auto editor = start();
    EditSession other(load_recipe("wood", {"atlas.size=64", "atlas.tries=1"}), "wood");
    other.save_recipe(folder / "wood.json");
    play(*editor, R"({"drop": [")" + (folder / "wood.json") + R"("]}, {"settle": true})");
    EXPECT_EQ(editor->session().recipe(), other.recipe());
    play(*editor, R"({"drop": ["/nowhere/mesh.obj"]}, {"settle": true})");
    ASSERT_FALSE(editor->session().log().empty());
    EXPECT_TRUE(editor->session().log().back().problem);
    EXPECT_EQ(editor->session().recipe(), other.recipe());
}

TEST_F(GlEditProgramTest, TheTitleNamesRecipeAndMeshAndTellsWhatIsNotSaved) {
    const auto editor = start();
    EXPECT_EQ(editor->title(), "marble on sample:cube - Burl");
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
                     {"drag": "texture.input.noise.0.amplitude", "by": [9, 0]})");
    EXPECT_EQ(editor->title(), "marble * on sample:cube - Burl");
    play(*editor, R"({"drop": ["sample:torus"]}, {"settle": true}, {"key": "Ctrl+Z"})");
    EXPECT_EQ(editor->title(), "marble on sample:torus - Burl");
}

TEST_F(GlEditProgramTest, AMeshOpensFromTheFirstFrameOnUntilItsFinestPictureIsSmooth) {
    const auto editor = start();
    EXPECT_FALSE(editor->opening());
    EXPECT_TRUE(editor->shown_smooth());
    editor->frame({{InputKind::drop, {}, 0, false, {}, {"sample:teapot"}}});
    EXPECT_TRUE(editor->opening());
    while (editor->opening()) {
        editor->turn();
        EXPECT_TRUE(editor->shown()->level == 0 || !editor->shown_smooth());
    }
    EXPECT_EQ(editor->shown(), editor->baker().front().picture().get());
    EXPECT_EQ(editor->shown()->level, 0u);
    for (int i = 0; i < 20 && !editor->shown_smooth(); ++i) editor->turn();
    EXPECT_TRUE(editor->shown_smooth());
    while (!editor->baker().idle()) editor->turn();
    EXPECT_TRUE(editor->baker().front().pick()) << "what was held goes on";
}

TEST_F(GlEditProgramTest, NoFrameIsDrawnWhileNothingHappens) {
    const auto editor = start();
    const auto frames_in = [&](int turns) {
        int frames = 0;
        for (int i = 0; i < turns; ++i) {
            const std::uint64_t before = editor->frames();
            editor->turn();
            frames += int(editor->frames() - before);
        }
        return frames;
    };
    for (const char* tab : {"Library", "Parameters", "Colours", "Metrics", "Log"}) {
        play(*editor, std::string(R"({"click": "tab:)") + tab + R"("}, {"settle": true})");
        frames_in(20);
        EXPECT_EQ(frames_in(200), 0) << tab;
    }
    play(*editor, R"({"key": "N"}, {"settle": true})");
    frames_in(20);
    EXPECT_EQ(frames_in(200), 0) << "the graph";
    editor->session().set({"texture.input.noise.0.amplitude=0.7"});
    play(*editor, R"({"wait": 1})");
    while (!editor->baker().idle()) editor->turn();
    EXPECT_GT(frames_in(50), 0) << "a texture that was made is shown";
    EXPECT_EQ(editor->shown(), editor->baker().front().picture().get());
    EXPECT_EQ(frames_in(200), 0);
}

TEST_F(GlEditProgramTest, SavesAndExportsThroughTheDialog) {
    const ScratchFolder folder;
    const auto editor = start();
    const std::string recipe = folder / "mine.json", picture = folder / "mine.png";
    play(*editor,
         R"({"key": "Ctrl+S"}, {"wait": 2}, {"double_click": "file name"}, {"key": "Ctrl+A"},
        {"type": ")" +
             recipe + R"("}, {"click": "file ok"}, {"wait": 2})");
    EXPECT_EQ(load_recipe(recipe), editor->session().recipe());
    play(*editor,
         R"({"key": "Ctrl+E"}, {"wait": 2}, {"double_click": "file name"}, {"key": "Ctrl+A"},
        {"type": ")" +
             picture + R"("}, {"click": "file ok"}, {"settle": true})");
    bake_file({"sample:cube", editor->session().recipe(), folder / "expected.png"});
    EXPECT_EQ(read_file_bytes(picture), read_file_bytes(folder / "expected.png"));
}

/// Desktops know a recipe by this name (assets/install/burl.xml).
TEST_F(GlEditProgramTest, ARecipeIsSavedAsDesktopsKnowIt) {
    const ScratchFolder folder;
    const auto editor = start();
    const Recipe recipe = editor->session().recipe();
    play(*editor, R"({"key": "Ctrl+S"}, {"wait": 3}, {"type": ")" + folder.path() + R"("},
        {"key": "Enter"}, {"wait": 3}, {"key": "Enter"}, {"wait": 2})");
    EXPECT_EQ(load_recipe(folder / (recipe.name + ".burl.json")), recipe);
}

/// Nobody has to click into the dialog first, and no letter is a shortcut.
TEST_F(GlEditProgramTest, ADialogTakesWhatIsTyped) {
    const ScratchFolder folder;
    const auto editor = start();
    const Recipe recipe = editor->session().recipe();
    play(*editor, R"({"key": "Ctrl+S"}, {"wait": 3}, {"type": ")" + (folder / "mine") +
                      R"("}, {"wait": 2}, {"key": "Enter"}, {"wait": 2})");
    EXPECT_EQ(load_recipe(folder / "mine.burl.json"), recipe);
    EXPECT_FALSE(editor->items().find("file name"));
    play(*editor, R"({"key": "Ctrl+O"}, {"wait": 3}, {"key": "Escape"}, {"wait": 2})");
    EXPECT_FALSE(editor->items().find("file name"));
    play(*editor, R"({"key": "Ctrl+O"}, {"wait": 3}, {"click": "file:.."}, {"wait": 3},
        {"key": "V"}, {"key": "G"}, {"wait": 2})");
    EXPECT_FALSE(editor->atlas().state.shown);
    EXPECT_FALSE(editor->items().find("move.axes"));
}

TEST_F(GlEditProgramTest, AsksBeforeItLosesWhatIsNotSaved) {
    const ScratchFolder folder;
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [30, 0]}, {"key": "Ctrl+Q"}, {"wait": 2})");
    EXPECT_FALSE(editor->wants_to_close());
    play(*editor, R"({"click": "Stay"}, {"wait": 2})");
    EXPECT_FALSE(editor->items().find("Stay"));
    EXPECT_FALSE(editor->wants_to_close());
    editor->session().save_recipe(folder / "r.json");
    play(*editor, R"({"drag": "texture.input.noise.0.amplitude", "by": [10, 0]},
        {"events": [{"close": true}]}, {"wait": 2}, {"click": "Save it"})");
    EXPECT_TRUE(editor->wants_to_close());
    EXPECT_EQ(load_recipe(folder / "r.json"), editor->session().recipe());
}

TEST_F(GlEditProgramTest, WithNothingToLoseItQuitsAtOnce) {
    const auto editor = start();
    play(*editor, R"({"key": "Ctrl+Q"}, {"wait": 2})");
    EXPECT_TRUE(editor->wants_to_close());
}

TEST_F(GlEditProgramTest, ToolsCoverLittleOfTheObject) {
    const auto editor = start();
    for (const auto& [key, window] :
         {std::pair{"P", "Paint (P)"}, std::pair{"G", "Move the texture (G)"}}) {
        play(*editor, std::string(R"({"key": ")") + key + R"("}, {"wait": 3})");
        const ImGuiWindow* shown = ImGui::FindWindowByName(window);
        ASSERT_NE(shown, nullptr);
        EXPECT_LT(shown->Size.x, 260.0f) << window;
    }
}

TEST_F(GlEditProgramTest, AScriptResizesTheWindow) {
    const auto editor = start();
    play(*editor, R"({"resize": [500, 400]}, {"wait": 3})");
    const Image<Rgb8> screen = editor->screenshot();
    EXPECT_EQ(screen.width(), 500u);
    EXPECT_EQ(screen.height(), 400u);
    const auto object = editor->items().find("object").value();
    EXPECT_NEAR(object.high.y, 400.0, 1.0);
    EXPECT_GT(object.high.x, 200.0);
    EXPECT_NE(screen(120, 200), screen(4, 396));  // the cube before its background
    EXPECT_THROW(play(*editor, R"({"resize": [0, 400]})"), Error);
}

/// Down to where there is no room for anything.
TEST_F(GlEditProgramTest, AWindowOfAnyWidthIsDrawn) {
    const auto editor = start();
    std::string sizes = R"({"resize": [64, 202]})";
    for (int width = 65; width < 200; ++width)
        sizes += fmt::format(R"(, {{"resize": [{}, 202]}})", width);
    for (const char* tab : {"Library", "Colours"}) {
        play(*editor, fmt::format(R"({{"resize": [800, 640]}}, {{"wait": 2}},
                                     {{"click": "tab:{}"}}, {{"wait": 2}})",
                                  tab));
        play(*editor, sizes);
        EXPECT_EQ(editor->screenshot().width(), 199u);
    }
}

/// In the one frame in which the one menu is closed and the other not shown.
TEST_F(GlEditProgramTest, EscapeBetweenTwoMenusClosesThem) {
    const auto editor = start();
    play(*editor, R"({"click": "menu:File"}, {"wait": 3})");
    ASSERT_TRUE(editor->items().find("menu:Quit"));
    const glm::dvec2 at = editor->items().find("menu:Edit").value().middle();
    editor->frame({{InputKind::move, at}});
    InputEvent escape{InputKind::key};
    escape.text = "Escape";
    escape.down = true;
    editor->frame({escape});
    escape.down = false;
    editor->frame({escape});
    play(*editor, R"({"wait": 3})");
    EXPECT_FALSE(editor->items().find("menu:Quit"));
}

TEST_F(GlEditProgramTest, AnEditEndsTheComparison) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [30, 0]}, {"key": "A"}, {"wait": 2})");
    const Image<Rgb8> opened = settled(*editor);
    play(*editor, R"({"drag": "texture.input.noise.0.amplitude", "by": [-20, 0]})");
    EXPECT_GT(different(*editor, opened), 3000u);
    const Image<Rgb8> edited = settled(*editor);
    play(*editor, R"({"key": "A"}, {"wait": 2})");
    EXPECT_EQ(different(*editor, edited) > 0, true);
}

/// Pressed again where it was let go, a slider has the same number: its range has stayed.
TEST_F(GlEditProgramTest, ASliderStaysWhereTheHandLeftIt) {
    const auto editor = start("wood");
    const double opened = editor->session().recipe().solid.scale;
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "solid.scale", "by": [-30, 0]}, {"wait": 2})");
    const double once = editor->session().recipe().solid.scale;
    EXPECT_LT(once, opened);
    play(*editor, R"({"wait": 30}, {"drag": "solid.scale", "by": [-30, 0]}, {"wait": 2})");
    EXPECT_NEAR(editor->session().recipe().solid.scale, once, 1e-6 * once);
}

TEST_F(GlEditProgramTest, OffersWhatACrashLeft) {
    const ScratchFolder folder;
    const std::string autosave = folder / "autosave.json";
    const Recipe lost = load_recipe("wood", {"atlas.size=64", "atlas.tries=1"});
    EditSession(lost, "").save_recipe(autosave);
    const auto editor = start("marble", autosave);
    play(*editor, R"({"click": "recover"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), lost);
    EXPECT_FALSE(editor->items().find("recover"));
    EXPECT_EQ(load_recipe(folder / "autosave-1.json"), lost) << "as long as it is not saved";
    play(*editor, R"({"key": "Ctrl+S"}, {"wait": 2})");
    EXPECT_TRUE(editor->items().find("file name")) << "it belongs to no file";
}

TEST_F(GlEditProgramTest, ARecordingReplaysToTheSamePicture) {
    const ScratchFolder folder;
    InputScript recorded;
    Image<Rgb8> first;
    Recipe recipe;
    {
        const auto editor = start();
        editor->record();
        play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
            {"drag": "texture.input.noise.0.gain", "by": [25, 0]}, {"drag": "object", "by": [40, 0]},
            {"settle": true}, {"wait": 2})");
        recorded = *editor->recording();
        first = settled(*editor);
        recipe = editor->session().recipe();
    }
    const auto editor = start();
    editor->play(parse_script(script_text(recorded), "recorded"), "");
    EXPECT_EQ(editor->session().recipe(), recipe);
    EXPECT_EQ(differing(first, settled(*editor)), 0u);
}

TEST_F(GlEditProgramTest, AnItemThatIsNotThereIsAnError) {
    const auto editor = start();
    EXPECT_THROW(play(*editor, R"({"click": "no such item"})"), Error);
}

}  // namespace
}  // namespace burl
