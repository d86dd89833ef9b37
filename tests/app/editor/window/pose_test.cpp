// Deformation in the editor as a person uses it, without a display.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/editor/window/fixture.h"
#include "tests/app/programs/run_program.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

constexpr int cells = 8;

/// A sheet of quads in x and y; `bend`: how far its right side comes forward.
std::string sheet_obj(double bend) {
    std::string text;
    for (int i = 0; i <= cells; ++i)
        for (int k = 0; k <= cells; ++k) {
            const double x = double(i) / cells;
            text += fmt::format("v {} {} {}\n", x, double(k) / cells, bend * x * x);
        }
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k) {
            const int a = i * (cells + 1) + k + 1, b = a + cells + 1;
            text += fmt::format("f {} {} {} {}\n", a, b, b + 1, a + 1);
        }
    return text;
}

class GlEditPoseTest : public GlEditProgramTest {
  protected:
    GlEditPoseTest() {
        write_file(folder / "sheet.obj", sheet_obj(0.0));
        write_file(folder / "bent.obj", sheet_obj(0.8));
        write_file(folder / "r.json",
                   to_json(load_recipe("marble", {"atlas.size=64", "atlas.tries=1"})));
        EditorOptions options;
        options.light = "headlight";  // an environment takes longer to prepare than most tests
        options.mesh = folder / "sheet.obj";
        options.recipe = folder / "r.json";
        options.gallery = false;
        editor = std::make_unique<EditorProgram>(
            create_unseen_window(create_test_context(), {800, 640}), options);
        play(*editor, settle);
    }
    void choose(const std::string& path) {
        play(*editor,
             R"({"double_click": "file name"}, {"key": "Ctrl+A"}, {"type": ")" + path +
                 R"("}, {"wait": 2}, {"click": "file ok"}, {"settle": true}, {"wait": 2})");
    }
    void open_pose(const std::string& name) {
        play(*editor, R"({"click": "menu:File"}, {"wait": 2}, {"click": "menu:Open pose..."},
                         {"wait": 2})");
        choose(folder / name);
    }
    std::string last_line() const { return editor->session().log().back().text; }

    static constexpr const char* settle = R"({"settle": true}, {"wait": 2})";
    ScratchFolder folder;
    std::unique_ptr<EditorProgram> editor;
};

TEST_F(GlEditPoseTest, AWeightMovesTheObjectAndNoTexture) {
    const Image<Rgb8> rest = settled(*editor);
    open_pose("bent.obj");
    const std::uint64_t runs = editor->baker().front().records()[Stage::synthesis].runs;
    EXPECT_EQ(runs, 1u);  // the pose has made none
    EXPECT_GT(different(*editor, rest), 500u);
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2})");
    const Image<Rgb8> posed = settled(*editor);
    const std::uint64_t request = editor->last_request();
    play(*editor, R"({"drag": "pose.weight", "by": [-60, 0]}, {"settle": true}, {"wait": 2})");
    EXPECT_LT(editor->session().recipe().pose.weight, 1.0);
    EXPECT_GT(different(*editor, posed), 500u);
    play(*editor, R"({"key": "Ctrl+Z"}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe().pose.weight, 1.0);
    EXPECT_EQ(different(*editor, posed), 0u);
    EXPECT_EQ(editor->last_request(), request);
    EXPECT_EQ(editor->baker().front().records()[Stage::synthesis].runs, runs);
    play(*editor, R"({"click": "menu:File"}, {"wait": 2}, {"click": "menu:Close pose"},
                     {"settle": true}, {"click": "tab:Library"}, {"wait": 2})");
    EXPECT_EQ(different(*editor, rest), 0u);
    EXPECT_EQ(editor->baker().front().records()[Stage::synthesis].runs, runs);
}

TEST_F(GlEditPoseTest, AnExportIsWhatTheCommandLineOfTheLogWrites) {
    open_pose("bent.obj");
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
                     {"drag": "pose.weight", "by": [-40, 0]}, {"key": "Ctrl+E"}, {"wait": 2})");
    choose(folder / "out.glb");
    const auto bytes = read_file_bytes(folder / "out.glb");
    std::string command;
    for (const LogLine& line : editor->session().log())
        if (const auto at = line.text.find("burl bake"); at != std::string::npos)
            command = line.text.substr(at + 5);
    ASSERT_NE(command.find("--pose"), std::string::npos) << command;
    std::filesystem::remove(folder / "out.glb");
    const test::Scratch scratch;
    const test::Outcome outcome = test::run_burl(scratch, command);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read_file_bytes(folder / "out.glb"), bytes);
}

/// A bake with a pose is a file that has one itself.
TEST_F(GlEditPoseTest, APoseOfTheFileIsInItsMenuAndItsWeightIsKeyed) {
    const test::Scratch scratch;
    const std::string own = folder / "own.glb";
    const std::string bake = fmt::format("bake {} --pose {} -r {} -o {}", folder / "sheet.obj",
                                         folder / "bent.obj", folder / "r.json", own);
    ASSERT_EQ(test::run_burl(scratch, bake).exit_code, 0);
    play(*editor, R"({"drop": [")" + own + R"("]}, {"settle": true}, {"wait": 2})");
    const Image<Rgb8> rest = settled(*editor);
    play(*editor, R"({"click": "menu:File"}, {"wait": 2}, {"click": "menu:Poses of the file"},
                     {"wait": 2}, {"click": "pose:bent"}, {"settle": true}, {"wait": 2})");
    EXPECT_GT(different(*editor, rest), 500u);
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2}, {"key": "K"}, {"wait": 2},
        {"drag": "pose.weight", "by": [-30, 0]}, {"click": "timeline.key"},
        {"drag": "timeline.ruler", "by": [120, 0]}, {"wait": 2},
        {"drag": "pose.weight", "by": [-200, 0]}, {"wait": 2})");
    const std::vector<KeyTrack> tracks = editor->session().recipe().animation.tracks;
    ASSERT_EQ(tracks.size(), 1u);
    EXPECT_EQ(tracks[0].path, "pose.weight");
    ASSERT_EQ(tracks[0].keys.size(), 2u);
    EXPECT_EQ(tracks[0].keys[1].value, 0.0);
    const Image<Rgb8> flat = settled(*editor);
    editor->session().set_time(0.0);
    play(*editor, settle);
    EXPECT_GT(different(*editor, flat), 500u);  // the object, and the timeline's clock
    EXPECT_EQ(editor->baker().front().records()[Stage::synthesis].runs, 1u);
}

TEST_F(GlEditPoseTest, PaintGoesWhereTheSurfaceWasAtRest) {
    open_pose("bent.obj");
    play(*editor, R"({"key": "P"}, {"wait": 2}, {"click": "object"}, {"settle": true})");
    const std::vector<PaintStroke> paint = editor->session().recipe().paint;
    ASSERT_EQ(paint.size(), 1u);
    // The sheet at rest is flat, and its middle the solid's origin.
    for (const Vec3d& p : paint[0].points) EXPECT_NEAR(p.z, 0.0, 1e-6);
    EXPECT_LT(std::abs(paint[0].points[0].x), 0.5);
}

TEST_F(GlEditPoseTest, OtherMeshesAreToldAndChangeNothing) {
    write_file(folder / "other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Image<Rgb8> rest = settled(*editor);
    open_pose("other.obj");
    EXPECT_NE(last_line().find("1 faces"), std::string::npos) << last_line();
    play(*editor, R"({"wait": 800})");  // until the complaint is gone from the object
    EXPECT_EQ(settled(*editor), rest);
}

TEST_F(GlEditPoseTest, APoseThatChangesOnDiskIsReadAgain) {
    open_pose("bent.obj");
    const Image<Rgb8> before = settled(*editor);
    write_file(folder / "bent.obj", sheet_obj(-0.8));
    play(*editor, settle);
    EXPECT_GT(different(*editor, before), 500u);
    EXPECT_EQ(editor->baker().front().records()[Stage::synthesis].runs, 1u);
}

}  // namespace
}  // namespace burl
