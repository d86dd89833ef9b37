// The editor's files as a person handles them: dropped, changed by other programs, opened again
// from the menu, and exported.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/image/image_io.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/editor/window/files_fixture.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(GlEditFilesTest, ADroppedMeshTakesThePlaceOfTheOldOne) {
    write_file(folder / "m.obj", square);
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    const Image<Rgb8> before = settled(*editor);
    play(*editor, dropped(folder / "m.obj"));
    EXPECT_EQ(triangles(*editor), 2u);
    EXPECT_EQ(editor->files().mesh(), folder / "m.obj");
    EXPECT_EQ(editor->baker().front().picture()->surface,
              editor->baker().front().surface()->number);
    EXPECT_GT(different(*editor, before), 3000u);
    // What cannot be read is said, and changes nothing but the log.
    const Image<Rgb8> after = settled(*editor);
    write_file(folder / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    play(*editor, dropped(folder / "bad.obj"));
    EXPECT_GT(different(*editor, after), 500u);
    play(*editor, R"({"click": "Dismiss"}, {"wait": 2})");
    EXPECT_FALSE(editor->items().find("Dismiss"));
    EXPECT_EQ(different(*editor, after), 0u);
    EXPECT_EQ(editor->files().mesh(), folder / "m.obj");
    EXPECT_TRUE(editor->session().log().back().problem);
    EXPECT_NE(editor->session().log().back().text.find("bad.obj:2"), std::string::npos);
}

TEST_F(GlEditFilesTest, AMeshThatChangesOnDiskIsShownFromWhereOneStands) {
    write_file(folder / "m.obj", square);
    save("marble");
    const auto editor = open(folder / "m.obj", folder / "r.json");
    play(*editor, R"({"drag": "object", "by": [80, 30]}, {"settle": true})");
    const EditCamera camera = editor->camera();
    write_file(folder / "m.obj", triangle);
    play(*editor, settle);
    EXPECT_EQ(triangles(*editor), 1u);
    EXPECT_EQ(editor->camera(), camera);
    write_file(folder / "m.obj", square);
    play(*editor, R"({"key": "F5"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(triangles(*editor), 2u);
}

TEST_F(GlEditFilesTest, ARecipeThatChangesOnDiskIsOneStep) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    const Recipe before = editor->session().recipe();
    save("wood");
    play(*editor, settle);
    EXPECT_EQ(editor->session().recipe(), load_recipe(folder / "r.json"));
    EXPECT_FALSE(editor->session().history().changed());
    play(*editor, R"({"key": "Ctrl+Z"}, {"settle": true})");
    EXPECT_EQ(editor->session().recipe(), before);
}

TEST_F(GlEditFilesTest, ARecipeReadAgainLeavesTheClockWhereItIs) {
    save("forming-marble");
    const auto editor = open("sample:cube", folder / "r.json");
    editor->session().set_time(1.5);
    save("forming-marble", "solid.scale=2");
    play(*editor, settle);
    ASSERT_EQ(editor->session().recipe(), load_recipe(folder / "r.json"));
    EXPECT_EQ(editor->session().time(), 1.5);
    save("forming-marble", "animation.seconds=1");  // which ends before that
    play(*editor, settle);
    EXPECT_EQ(editor->session().time(), 1.0);
}

TEST_F(GlEditFilesTest, ABallIsLargeWhereThePointerRests) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json", true);
    play(*editor, R"({"click": "category:classic"}, {"wait": 2},
        {"wheel": "preset:sine-marble", "by": [0, 0]}, {"wait": 5})");
    EXPECT_FALSE(editor->items().find("preset enlarged"));
    play(*editor, R"({"wait": 20}, {"settle": true}, {"wait": 2})");
    const auto large = editor->items().find("preset enlarged");
    const auto small = editor->items().find("preset:sine-marble");
    ASSERT_TRUE(large && small);
    EXPECT_GT(large->high.x - large->low.x, 1.5 * (small->high.x - small->low.x));
    // Its picture is there: a ball has more colours than what stands in for one.
    const Image<Rgb8> screen = editor->screenshot();
    std::set<std::array<std::uint8_t, 3>> colors;
    for (std::size_t x = std::size_t(large->low.x) + 4; x < std::size_t(large->high.x) - 4; ++x) {
        const Rgb8& c = screen(x, std::size_t(large->middle().y));
        colors.insert({c.r, c.g, c.b});
    }
    EXPECT_GT(colors.size(), 20u);
}

TEST_F(GlEditFilesTest, EditsAreNotLostToTheDisk) {
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2})");
    const auto edit = [&] {
        play(*editor,
             R"({"drag": "texture.input.noise.0.amplitude", "by": [30, 0]}, {"settle": true})");
        return editor->session().recipe();
    };
    const Recipe edited = edit();
    save("wood");
    play(*editor, settle);
    EXPECT_EQ(editor->session().recipe(), edited);
    EXPECT_TRUE(editor->session().log().back().problem);
    play(*editor, R"({"click": "Keep this one"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), edited);
    EXPECT_FALSE(editor->items().find("Keep this one"));
    save("wood", "solid.scale=2");
    play(*editor, settle);
    play(*editor, R"({"click": "Take the file's"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(editor->session().recipe(), load_recipe(folder / "r.json"));
    EXPECT_FALSE(editor->items().find("Take the file's"));
    play(*editor, R"({"key": "Ctrl+Z"}, {"settle": true})");
    EXPECT_EQ(editor->session().recipe(), edited);
}

/// Whichever of its files is there already.
TEST_F(GlEditFilesTest, AnExportAsksBeforeItReplacesAFile) {
    save("marble");
    write_file(folder / "out.png", "a picture");
    write_file(folder / "out.mtl", "a material");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"key": "Ctrl+E"}, {"wait": 3}, {"type": ")" + (folder / "out.obj") +
                      R"("}, {"wait": 2}, {"key": "Enter"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(outputs().size(), 2u);
    ASSERT_TRUE(editor->items().find("file replace"));
    play(*editor, R"({"key": "Enter"}, {"settle": true}, {"wait": 2})");
    EXPECT_EQ(text("out.png"), "a picture") << "a second Enter is no answer";
    play(*editor, R"({"click": "file back"}, {"wait": 2})");
    EXPECT_FALSE(editor->items().find("file replace"));
    play(*editor, R"({"click": "file ok"}, {"wait": 2}, {"click": "file replace"},
        {"settle": true}, {"wait": 2})");
    EXPECT_EQ(outputs().size(), 3u);
    EXPECT_NE(text("out.png"), "a picture");
    EXPECT_NE(text("out.mtl"), "a material");
}

TEST_F(GlEditFilesTest, AnExportDoesNotReplaceTheRecipesImage) {
    write_png(folder / "image.png", Image<Rgb8>(2, 2));
    const std::string before = text("image.png");
    write_file(folder / "r.json", R"({"texture": {"node": "image", "file": "image.png"},
        "atlas": {"size": 64, "tries": 1}})");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"key": "Ctrl+E"}, {"wait": 3}, {"type": ")" + (folder / "image.png") +
                      R"("}, {"wait": 2}, {"key": "Enter"}, {"wait": 2}, {"click": "file replace"},
                      {"settle": true}, {"wait": 2})");
    EXPECT_EQ(text("image.png"), before);
    EXPECT_TRUE(editor->session().log().back().problem);
}

TEST_F(GlEditFilesTest, ScreenshotsOfEverySessionAreKept) {
    save("marble");
    write_file(folder / "burl-001.png", "of somebody else");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    for (int session = 0; session < 2; ++session) {
        const auto editor = open("sample:cube", folder / "r.json");
        play(*editor, R"({"key": "F12"}, {"wait": 2}, {"key": "F12"}, {"wait": 2})");
    }
    std::filesystem::current_path(before);
    EXPECT_EQ(text("burl-001.png"), "of somebody else");
    for (const char* name : {"burl-002.png", "burl-003.png", "burl-004.png", "burl-005.png"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    EXPECT_FALSE(std::filesystem::exists(folder / "burl-006.png"));
}

TEST_F(GlEditFilesTest, RecentFilesOpenFromTheMenu) {
    write_file(folder / "m.obj", square);
    write_file(folder / "n.obj", triangle);
    save("marble");
    {
        const auto editor = open(folder / "m.obj", folder / "r.json");
        play(*editor, dropped(folder / "n.obj"));
    }
    const auto editor = open("sample:cube", folder / "r.json");
    const auto menu = [&](const std::string& name) {
        play(*editor,
             R"({"click": "menu:File"}, {"wait": 2}, {"click": "menu:Open recent"}, {"wait": 2},
                {"click": "recent:)" +
                 name + R"("}, {"settle": true}, {"wait": 2})");
    };
    menu("m.obj");
    EXPECT_EQ(triangles(*editor), 2u);
    std::filesystem::remove(folder / "n.obj");
    menu("n.obj");  // it is grey
    EXPECT_EQ(triangles(*editor), 2u);
}

/// The command that the log names, run by the shell, writes the same bytes.
TEST_F(GlEditFilesTest, ExportsWhatTheCommandInTheLogWrites) {
    const test::Scratch scratch;
    save("marble");
    const auto editor = open("sample:cube", folder / "r.json");
    play(*editor, R"({"click": "tab:Parameters"}, {"wait": 2},
        {"drag": "texture.input.noise.0.amplitude", "by": [30, 0]}, {"settle": true})");
    bool chosen = false;  // what was chosen for the last export is offered for the next
    const auto exported = [&](const std::string& name, bool levels) {
        const std::string choice = levels != chosen ? R"({"click": "file choice"},)" : "";
        chosen = levels;
        play(*editor, R"({"key": "Ctrl+E"}, {"wait": 2},)" + choice +
                          R"({"double_click": "file name"}, {"key": "Ctrl+A"}, {"type": ")" +
                          (folder / name) + R"("}, {"wait": 2}, {"click": "file ok"},
                          {"settle": true}, {"wait": 2})");
        std::map<std::string, std::vector<std::uint8_t>> files;
        for (const std::string& file : outputs()) files[file] = read_file_bytes(folder / file);
        return files;
    };
    const auto command = [&] {
        std::string text;
        for (const LogLine& line : editor->session().log())
            if (line.text.starts_with("exporting"))
                text = line.text.substr(line.text.find("burl bake") + 5);
        return text;
    };
    for (const auto& [name, levels] :
         std::vector<std::pair<std::string, bool>>{{"out.glb", false},
                                                   {"out.gltf", true},
                                                   {"out.obj", false},
                                                   {"out.png", true},
                                                   {"out.exr", true},
                                                   {"out.frag", false},
                                                   {"out.glsl", false}}) {
        SCOPED_TRACE(name);
        const auto ours = exported(name, levels);
        ASSERT_TRUE(ours.contains(name)) << editor->session().log().back().text;
        if (name == "out.png") {
            EXPECT_EQ(ours.size(), 7u);  // 64 to 1
        }
        for (const std::string& file : outputs()) std::filesystem::remove(folder / file);
        const test::Outcome run = test::run_burl(scratch, command());
        ASSERT_EQ(run.exit_code, 0) << run.err;
        for (const auto& [file, bytes] : ours) EXPECT_EQ(read_file_bytes(folder / file), bytes);
        for (const std::string& file : outputs()) std::filesystem::remove(folder / file);
    }
}

TEST_F(GlEditFilesTest, ABadFileDroppedBeforeTheFirstMeshIsThereEndsNothing) {
    write_file(folder / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    save("marble");
    EditorOptions options;
    options.light = "headlight";  // an environment takes longer to prepare than most tests
    options.mesh = "sample:cube";
    options.recipe = folder / "r.json";
    options.gallery = false;
    EditorProgram editor(create_unseen_window(create_test_context(), {400, 320}), options);
    InputEvent drop{InputKind::drop};
    drop.files = {folder / "bad.obj"};
    editor.frame({drop});
    play(editor, settle);
    EXPECT_EQ(editor.files().mesh(), "sample:cube");
    EXPECT_GT(triangles(editor), 0u);
    EXPECT_TRUE(std::ranges::any_of(editor.session().log(), [](const auto& entry) {
        return entry.text.find("bad.obj:2") != std::string::npos;
    })) << "whichever file was read first";
}

TEST_F(GlEditFilesTest, AFirstMeshThatCannotBeReadEndsIt) {
    EXPECT_THROW(open(folder / "missing.obj", "marble"), Error);
}

}  // namespace
}  // namespace burl
