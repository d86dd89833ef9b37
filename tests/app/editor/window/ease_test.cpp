// What trials of the editor stumbled over, each once.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/editor/jobs/export.h"
#include "app/editor/panels/files.h"
#include "app/editor/session/autosave.h"
#include "app/editor/window/kept_view.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "tests/app/editor/window/files_fixture.h"

namespace burl {
namespace {

class GlEditEaseTest : public GlEditFilesTest {
  protected:
    static double amplitude(EditorProgram& editor) {
        return plain_texture(editor.session().recipe().texture)->noise.front().amplitude;
    }
    static double stop_place(EditorProgram& editor, std::size_t stop) {
        return plain_texture(editor.session().recipe().texture)->colors.stops[stop].position;
    }
    /// Takes hold of an item in its middle and returns where that is.
    static glm::dvec2 press(EditorProgram& editor, const std::string& item) {
        const glm::dvec2 at = editor.items().find(item).value().middle();
        play(editor, fmt::format(R"({{"events": [{{"move": [{0}, {1}]}}]}},
            {{"events": [{{"button": 0, "down": true}}]}})",
                                 at.x, at.y));
        return at;
    }
    static void move_to(EditorProgram& editor, const glm::dvec2& at) {
        play(editor, fmt::format(R"({{"events": [{{"move": [{}, {}]}}]}})", at.x, at.y));
    }
    static constexpr const char* release = R"({"events": [{"button": 0, "down": false}]})";
    static constexpr const char* shift = R"({"events": [{"key": "Shift", "down": true}]})";
    static constexpr const char* no_shift = R"({"events": [{"key": "Shift", "down": false}]})";
    static constexpr const char* slider = "texture.input.noise.0.amplitude";
};

TEST_F(GlEditEaseTest, ShiftMovesASliderATenthAsFarWithoutAJump) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2})");
    const double before = amplitude(*editor);
    glm::dvec2 at = press(*editor, slider);
    const double pressed = amplitude(*editor);
    move_to(*editor, at + glm::dvec2(20, 0));
    const double by_20 = amplitude(*editor) - pressed;
    EXPECT_GT(by_20, 0.0);
    play(*editor, std::string(release) + R"(, {"key": "Ctrl+Z"}, {"wait": 30})");
    ASSERT_EQ(amplitude(*editor), before);

    play(*editor, shift);
    at = press(*editor, slider);
    EXPECT_EQ(amplitude(*editor), before) << "the press alone moves nothing";
    move_to(*editor, at + glm::dvec2(40, 0));
    const double slow = amplitude(*editor);
    EXPECT_NEAR(slow - before, 0.2 * by_20, 0.02 * by_20);
    play(*editor, no_shift);
    EXPECT_EQ(amplitude(*editor), slow) << "nor does letting go of Shift";
    move_to(*editor, at + glm::dvec2(60, 0));
    EXPECT_NEAR(amplitude(*editor) - slow, by_20, 0.02 * by_20);
    const double last = amplitude(*editor);
    play(*editor, release);
    EXPECT_EQ(amplitude(*editor), last);
}

/// A number far beyond the usual range, and back.
TEST_F(GlEditEaseTest, ASlidersRangeIsTheUsualOneAgainAfterATypedNumber) {
    const auto editor = start();
    const auto type = [&](const char* number) {
        play(*editor,
             fmt::format(R"({{"wait": 30}}, {{"events": [{{"key": "Ctrl", "down": true}}]}},
            {{"click": "solid.scale"}}, {{"events": [{{"key": "Ctrl", "down": false}}]}},
            {{"type": "{}"}}, {{"key": "Enter"}}, {{"wait": 2}})",
                         number));
    };
    const auto scale = [&] { return editor->session().recipe().solid.scale; };
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2})");
    type("1");
    play(*editor, R"({"wait": 30}, {"drag": "solid.scale", "by": [10, 0]}, {"wait": 2})");
    const double usual = scale();
    type("900");
    ASSERT_EQ(scale(), 900.0);
    play(*editor, R"({"wait": 30}, {"drag": "solid.scale", "by": [-1000, 0]}, {"wait": 2})");
    EXPECT_LT(scale(), 1.0);
    type("1");
    play(*editor, R"({"wait": 30}, {"drag": "solid.scale", "by": [10, 0]}, {"wait": 2})");
    EXPECT_NEAR(scale(), usual, 1e-9) << "as far as ever";
}

TEST_F(GlEditEaseTest, ADoubleClickGoesBackToWhatWasOpenedAndThenToTheDefault) {
    save("marble", "solid.scale=3");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "solid.scale", "by": [15, 0]})");
    ASSERT_NE(editor->session().recipe().solid.scale, 3.0);
    play(*editor, R"({"wait": 30}, {"double_click": "solid.scale"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe().solid.scale, 3.0);
    EXPECT_FALSE(editor->session().history().changed());
    play(*editor, R"({"wait": 30}, {"double_click": "solid.scale"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe().solid.scale, 1.0);
}

TEST_F(GlEditEaseTest, AStopIsDraggedPastAnotherInOneStep) {
    save("marble", R"(texture.stops=[[0,"#ff0000"],[0.5,"#00ff00"],[1,"#0000ff"]])");
    const auto editor = open("sample:cube", folder / "r.json");
    const Recipe before = editor->session().recipe();
    play(*editor, R"({"click": "tab:Colours"}, {"wait": 2},
        {"drag": "texture.stops.0", "by": [230, 0], "frames": 12}, {"wait": 2})");
    const auto& stops = plain_texture(editor->session().recipe().texture)->colors.stops;
    ASSERT_EQ(stops.size(), 3u);
    EXPECT_EQ(stops[0].color, (Rgb8{0, 255, 0}));
    EXPECT_EQ(stops[1].color, (Rgb8{255, 0, 0})) << "it is the red one that moved";
    EXPECT_GT(stop_place(*editor, 1), 0.55);
    play(*editor, R"({"key": "Ctrl+Z"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), before);
}

/// Keys name a stop by its index.
TEST_F(GlEditEaseTest, StopsWithKeysKeepTheirOrder) {
    save("marble", R"(texture.stops=[[0,"#ff0000"],[0.5,"#00ff00"],[1,"#0000ff"]])");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"key": "K"}, {"click": "tab:Colours"}, {"wait": 2},
        {"drag": "texture.stops.1", "by": [10, 0]}, {"key": "I"}, {"wait": 2},
        {"drag": "texture.stops.0", "by": [200, 0], "frames": 12}, {"wait": 2})");
    ASSERT_EQ(editor->session().recipe().animation.tracks.size(), 1u);
    const auto& stops = plain_texture(editor->session().still().texture)->colors.stops;
    EXPECT_EQ(stops[0].color, (Rgb8{255, 0, 0}));
    EXPECT_EQ(stops[0].position, stops[1].position);
}

TEST_F(GlEditEaseTest, AKeyIsNotTakenAwayByTheKeyThatSetsIt) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2}, {"key": "K"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [-4, 0]}, {"key": "I"}, {"wait": 2})");
    const KeyedAnimation set = editor->session().recipe().animation;
    ASSERT_EQ(set.tracks.size(), 1u);
    play(*editor, R"({"key": "I"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe().animation, set);
    play(*editor, R"({"click": "timeline.key"}, {"wait": 2})");
    EXPECT_TRUE(editor->session().recipe().animation.tracks.empty()) << "the button says so";
}

TEST_F(GlEditEaseTest, TheWheelBringsNearerWhatIsUnderThePointer) {
    const auto editor = start();
    const ItemRect view = editor->items().find("object").value();
    const glm::dvec2 at = view.middle() + glm::dvec2(70, -40), size = view.high - view.low;
    const PictureSize picture{int(size.x), int(size.y)};
    const Sphere sphere = editor->baker().front().surface()->sphere;
    const Camera before = camera_of(editor->camera(), sphere, picture);
    const double depth = sphere.radius * editor->camera().view.distance;
    const Vec3d point = ray_through(before, picture, at - view.low).at(depth);
    move_to(*editor, at);
    play(*editor, R"({"events": [{"wheel": [0, 5]}]}, {"wait": 2})");
    const Vec3d seen = project(camera_of(editor->camera(), sphere, picture), picture, point);
    EXPECT_NEAR(seen.x, at.x - view.low.x, 1.0);
    EXPECT_NEAR(seen.y, at.y - view.low.y, 1.0);
}

TEST_F(GlEditEaseTest, TheUpAxisIsOfTheMeshAndKept) {
    const auto with_state = [&](const std::string& mesh) {
        EditorOptions options;
        options.mesh = mesh;
        options.settings = {"atlas.size=64", "atlas.tries=1"};
        options.gallery = false;
        options.preferences = folder / "preferences.json";
        auto editor = std::make_unique<EditorProgram>(
            create_unseen_window(create_test_context(), {800, 640}), options);
        play(*editor, settle);
        return editor;
    };
    {
        const auto editor = with_state("sample:cube");
        play(*editor, R"({"click": "menu:View"}, {"wait": 3}, {"click": "menu:Up"}, {"wait": 3},
            {"click": "up:z"}, {"wait": 3})");
        EXPECT_EQ(editor->camera().up, UpAxis::z);
        play(*editor, dropped("sample:torus"));
        EXPECT_EQ(editor->camera().up, UpAxis::y);
    }
    EXPECT_EQ(with_state("sample:cube")->camera().up, UpAxis::z);
    EXPECT_EQ(with_state("sample:torus")->camera().up, UpAxis::y);
}

/// The window manager took Alt+F4 and kept the release of Alt.
TEST_F(GlEditEaseTest, AltDoesNotStickAfterStaying) {
    const auto editor = start();
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [30, 0]},
        {"events": [{"key": "Alt", "down": true}]}, {"events": [{"close": true}]}, {"wait": 2},
        {"click": "Stay"}, {"wait": 2}, {"key": "Ctrl+Z"}, {"wait": 2})");
    EXPECT_FALSE(ImGui::GetIO().KeyAlt);
    EXPECT_FALSE(editor->session().history().changed()) << "shortcuts work";
}

TEST_F(GlEditEaseTest, MenusCopyPasteAndCompare) {
    const auto editor = start();
    const Recipe marble = editor->session().recipe();
    const auto choose = [&](const char* entry) {
        play(*editor, fmt::format(R"({{"click": "menu:Edit"}}, {{"wait": 3}},
            {{"click": "menu:{}"}}, {{"wait": 3}})",
                                  entry));
    };
    choose("Copy the recipe");
    play(*editor, R"({"click": "category:classic"}, {"wait": 2}, {"click": "preset:wood"},
        {"wait": 2})");
    ASSERT_NE(editor->session().recipe(), marble);
    choose("Paste a recipe");
    EXPECT_EQ(editor->session().recipe(), marble);
    choose("Compare");
    EXPECT_NE(editor->session().recipe(), load_recipe("wood"));
    choose("Compare");
    choose("Copy the burl command");
    choose("Paste a recipe");
    EXPECT_TRUE(editor->session().log().back().problem) << "a command is no recipe";
}

TEST_F(GlEditEaseTest, ASignTellsOfACoarseLevel) {
    const auto editor = start();
    EXPECT_FALSE(editor->items().find("coarse level"));
    bool seen = false;
    editor->session().history().begin_gesture();
    for (int i = 0; i < 400 && !seen; ++i) {
        editor->session().set("atlas.size", i % 2 == 0 ? 4096 : 2048);
        editor->frame({});
        seen = editor->items().find("coarse level").has_value();
        EXPECT_EQ(seen, editor->shown() && editor->shown()->level > 0);
    }
    editor->session().history().end_gesture();
    editor->session().history().undo();
    play(*editor, settle);
    EXPECT_FALSE(editor->items().find("coarse level"));
}

TEST_F(GlEditEaseTest, WhatIsRecoveredHasItsMeshPoseAndCamera) {
    const std::string file = folder / "autosave.json";
    EditCamera camera;
    camera.view = {12, 34, 2.5};
    camera.target = {0.1, -0.2, 0.3};
    camera.up = UpAxis::z;
    {
        const auto editor = open("sample:torus", "marble");
        editor->camera() = camera;
        editor->session().set("solid.scale", 2);
        play(*editor, R"({"wait": 200})");
        ASSERT_TRUE(std::filesystem::exists(folder / "autosave.view"));
        // A crash leaves the files and no lock.
        std::filesystem::copy(file, folder / "left.json");
        std::filesystem::copy(folder / "autosave.view", folder / "left.view");
    }
    std::filesystem::rename(folder / "left.json", file);
    std::filesystem::rename(folder / "left.view", folder / "autosave.view");
    const auto editor = open("sample:cube", "marble");
    EXPECT_NE(editor->camera(), camera);
    play(*editor, R"({"wait": 2}, {"click": "recover"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(editor->files().mesh(), "sample:torus");
    EXPECT_EQ(editor->camera(), camera);
    EXPECT_EQ(editor->session().recipe().solid.scale, 2.0);
}

TEST_F(GlEditEaseTest, AnExportHasTheSizeAndTheMasksAskedFor) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"key": "Ctrl+E"}, {"wait": 3}, {"type": ")" + (folder / "out.png") +
                      R"("}, {"wait": 2}, {"click": "export size"}, {"wait": 3},
        {"click": "export size=256"}, {"wait": 3}, {"click": "export masks"}, {"wait": 3},
        {"click": "export mask:occlusion"}, {"wait": 2}, {"key": "Escape"}, {"wait": 3},
        {"click": "file ok"}, {"settle": true}, {"wait": 3})");
    ExportRequest expected{"sample:cube", editor->session().recipe(), folder / "expected.png"};
    expected.recipe.atlas.size = 256;
    expected.masks = {"occlusion"};
    bake_file(expected);
    EXPECT_EQ(read_file_bytes(folder / "out.png"), read_file_bytes(folder / "expected.png"));
    EXPECT_EQ(read_file_bytes(folder / "out_occlusion.png"),
              read_file_bytes(folder / "expected_occlusion.png"));
    EXPECT_EQ(editor->session().recipe().atlas.size, 64u) << "for the export alone";
}

TEST_F(GlEditEaseTest, AnExportTellsHowFarItIsAndStops) {
    Recipe recipe = load_recipe("forming-marble", {"atlas.size=64", "atlas.tries=1"});
    const ExportRequest request{"sample:cube", recipe, folder / "out.png"};
    std::vector<double> shares;
    std::stop_source stop;
    Course course;
    {
        const std::jthread watcher([&](const std::stop_token& done) {
            while (!done.stop_requested() && !stop.stop_requested()) {
                const ProgressState state = course.state();
                shares.push_back(state.share);
                if (state.round > 2 && state.share > 0.0) stop.request_stop();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        });
        EXPECT_THROW(bake_frames(request, stop.get_token(), &course), Error);
    }
    EXPECT_FALSE(course.state().task.empty());
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_GT(shares.back(), 0.0);
    EXPECT_LT(shares.back(), 1.0);
    const std::size_t frames = outputs().size();
    EXPECT_GT(frames, 0u);
    EXPECT_LT(frames, 40u);
    stop = {};
    stop.request_stop();
    EXPECT_THROW(
        bake_file({"sample:cube", load_recipe("marble"), folder / "none.png"}, stop.get_token()),
        Error);
    EXPECT_FALSE(std::filesystem::exists(folder / "none.png"));
}

TEST_F(GlEditEaseTest, ADialogKnowsHomePlacesAndNewFolders) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"key": "Ctrl+Shift+S"}, {"wait": 3}, {"click": "place:/"}, {"wait": 3})");
    EXPECT_EQ(editor->dialog().folder(), "/");
    play(*editor, R"({"type": ")" + folder.path() + R"("}, {"key": "Enter"}, {"wait": 3},
        {"click": "file new folder"}, {"wait": 3}, {"type": "mine"}, {"key": "Enter"},
        {"wait": 3})");
    const std::filesystem::path made = folder / "mine";
    EXPECT_TRUE(std::filesystem::is_directory(made));
    EXPECT_EQ(std::filesystem::path(editor->dialog().folder()), std::filesystem::canonical(made));
    play(*editor, R"({"click": "file:.."}, {"wait": 3}, {"click": "file:r.json"}, {"wait": 3},
        {"key": "Enter"}, {"wait": 3})");
    EXPECT_TRUE(editor->items().find("file replace")) << "Enter takes the file that was chosen";
    const char* home = std::getenv("HOME");
    EXPECT_EQ(expanded_home("~/a"), home && *home ? std::string(home) + "/a" : "~/a");
    EXPECT_EQ(expanded_home("/x/~"), "/x/~");
    EXPECT_EQ(expanded_home("~other/x"), "~other/x");
}

/// At any size of text every widget of the timeline is within its panel.
TEST_F(GlEditEaseTest, TheTimelineFitsWithLargeText) {
    const auto editor = start("forming-marble");
    play(*editor, R"({"resize": [1280, 800]}, {"key": "K"}, {"wait": 2})");
    for (const int steps : {0, 3}) {  // 100 and 175 %
        for (int i = 0; i < steps; ++i) play(*editor, R"({"key": "Ctrl+Plus"})");
        play(*editor, R"({"wait": 4})");
        const ItemRect object = editor->items().find("object").value();
        for (const char* item :
             {"timeline.play", "timeline.seconds", "timeline.rate", "timeline.loop",
              "timeline.number", "timeline.key", "timeline.ruler"}) {
            const auto rect = editor->items().find(item);
            ASSERT_TRUE(rect) << item;
            EXPECT_LE(rect->high.x, object.high.x) << item;
            EXPECT_GE(rect->low.y, object.high.y) << item;
            EXPECT_LE(rect->high.y, 800.0) << item;
        }
    }
}

TEST_F(GlEditEaseTest, ThePointersShapeSaysWhatItDoes) {
    const auto editor = start();
    const auto shape_over = [&](const std::string& item) {
        move_to(*editor, editor->items().find(item).value().middle());
        play(*editor, R"({"wait": 2})");
        return editor->pointer();
    };
    EXPECT_EQ(shape_over("object"), PointerShape::arrow);
    EXPECT_EQ(shape_over("splitter:side"), PointerShape::resize_sideways);
    EXPECT_EQ(shape_over("preset search"), PointerShape::text);
    play(*editor, R"({"key": "P"}, {"wait": 2})");
    EXPECT_EQ(shape_over("object"), PointerShape::cross);
    play(*editor, R"({"key": "G"}, {"wait": 2})");
    EXPECT_EQ(shape_over("object"), PointerShape::hand);
    EXPECT_EQ(shape_over("tab:Log"), PointerShape::arrow);
    play(*editor, R"({"key": "G"}, {"key": "K"}, {"wait": 2})");
    EXPECT_EQ(shape_over("splitter:timeline"), PointerShape::resize_upright);
}

}  // namespace
}  // namespace burl
