// The editor's files: what its browser lists, what survives a crash, and that an export is the
// bytes of a bake.
#include "app/editor/panels/files.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <memory>

#include <sys/wait.h>
#include <unistd.h>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/editor/jobs/export.h"
#include "app/editor/jobs/open_files.h"
#include "app/editor/session/autosave.h"
#include "app/image/image_io.h"
#include "app/pipeline/pipeline.h"
#include "atlas/base/error.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

TEST(EditFiles, ListsFoldersThenWantedFiles) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "z");
    for (const char* name : {"b.obj", "a.OBJ", "c.txt", ".hidden.obj"})
        write_file(folder / name, "");
    EXPECT_EQ(list_folder(folder.path(), {".obj", ".ply"}),
              (std::vector<FolderEntry>{{"z", true}, {"a.OBJ", false}, {"b.obj", false}}));
    EXPECT_EQ(list_folder(folder.path(), {}).size(), 4u);
    EXPECT_TRUE(list_folder(folder / "missing", {}).empty());
}

EditHistory edited_marble(const std::string& scale) {
    EditHistory history(load_recipe("marble"), "marble");
    history.change(load_recipe("marble", {"solid.scale=" + scale}));
    return history;
}

TEST(EditAutosave, SurvivesUntilSavedOrEndedWell) {
    const ScratchFolder folder;
    const std::string file = folder / "state/autosave.json";
    EditHistory history(load_recipe("marble"));
    auto autosave = std::make_unique<EditAutosave>(file);
    autosave->keep(history, 0.0);
    EXPECT_FALSE(std::filesystem::exists(file));
    history.change(load_recipe("marble", {"solid.scale=2"}));
    autosave->keep(history, 10.0);
    EXPECT_EQ(load_recipe(file), history.recipe());
    history.change(load_recipe("marble", {"solid.scale=3"}));
    autosave->keep(history, 10.5);  // too soon
    EXPECT_NE(load_recipe(file), history.recipe());
    autosave.reset();
    EditAutosave next(file);
    ASSERT_EQ(next.left_behind().size(), 1u);
    EXPECT_EQ(parse_recipe(next.left_behind()[0].json, "left").solid.scale, 2.0);
    next.throw_away(0);
    EXPECT_TRUE(next.left_behind().empty());
    next.keep(history, 11.0);
    EXPECT_EQ(load_recipe(file), history.recipe());
    history.mark_saved(folder / "r.json");
    next.keep(history, 12.0);
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(EditAutosave, APresetThatTakesTheRecipesPlaceLeavesIt) {
    const ScratchFolder folder;
    const std::string file = folder / "autosave.json";
    EditHistory history = edited_marble("2");
    const Recipe edited = history.recipe();
    EditAutosave autosave(file);
    autosave.keep(history, 0.0);
    history.open(load_recipe("wood"), "wood");
    autosave.keep(history, 10.0);
    ASSERT_TRUE(std::filesystem::exists(file));
    EXPECT_EQ(load_recipe(file), edited);
}

TEST(EditAutosave, EveryRecipeThatIsNotSavedHasAFile) {
    const ScratchFolder folder;
    const std::string file = folder / "autosave.json", second = folder / "autosave-1.json";
    EditHistory history = edited_marble("2");
    const Recipe first = history.recipe();
    {
        EditAutosave autosave(file);
        autosave.keep(history, 0.0);
        history.open(load_recipe("wood"), "wood");
        history.change(load_recipe("wood", {"solid.scale=3"}));
        autosave.keep(history, 10.0);
        EXPECT_EQ(load_recipe(file), first);
        EXPECT_EQ(load_recipe(second), history.recipe());
        history.mark_saved(folder / "w.json");
        autosave.keep(history, 20.0);
        EXPECT_EQ(load_recipe(file), first);
        EXPECT_FALSE(std::filesystem::exists(second));
        history.change(load_recipe("wood", {"solid.scale=4"}));
        autosave.keep(history, 30.0);
    }
    EXPECT_EQ(EditAutosave(file).left_behind().size(), 2u);
}

TEST(EditAutosave, WhatIsTakenLeavesWhatIsNotSaved) {
    const ScratchFolder folder;
    const std::string file = folder / "autosave.json";
    EditHistory history = edited_marble("2");
    const Recipe edited = history.recipe(), left = load_recipe("wood");
    write_file(file, to_json(left));
    EditAutosave autosave(file);
    autosave.keep(history, 0.0);
    history.open_unsaved(left);
    autosave.take(0, history);
    EXPECT_EQ(load_recipe(folder / "autosave-1.json"), edited);
    EXPECT_EQ(load_recipe(folder / "autosave-2.json"), left);
    EXPECT_FALSE(std::filesystem::exists(file));
    autosave.clear();
    EXPECT_TRUE(EditAutosave(file).left_behind().empty());
}

TEST(EditAutosave, EditorsThatRunHaveOneEach) {
    const ScratchFolder folder;
    const std::string file = folder / "autosave.json", second = folder / "autosave-1.json";
    const EditHistory a = edited_marble("2"), b = edited_marble("3");
    EditAutosave one(file);
    one.keep(a, 0.0);
    EditAutosave two(file);
    EXPECT_TRUE(two.left_behind().empty()) << "the first one's editor runs";
    two.keep(b, 0.0);
    EXPECT_EQ(load_recipe(file), a.recipe());
    EXPECT_EQ(load_recipe(second), b.recipe());
    two.clear();
    EXPECT_EQ(load_recipe(file), a.recipe());
    EXPECT_FALSE(std::filesystem::exists(second));
}

TEST(EditAutosave, OffersWhatSeveralEditorsLeftOnce) {
    const ScratchFolder folder;
    const std::string file = folder / "autosave.json";
    const EditHistory a = edited_marble("2"), b = edited_marble("3");
    {
        EditAutosave one(file), two(file);
        one.keep(a, 0.0);
        two.keep(b, 0.0);
    }
    EditAutosave next(file);
    ASSERT_EQ(next.left_behind().size(), 2u);
    EXPECT_EQ(parse_recipe(next.left_behind()[1].json, "left"), b.recipe());
    EXPECT_EQ(next.left_behind()[0].title, "marble, just now");
    EXPECT_TRUE(EditAutosave(file).left_behind().empty()) << "another editor asks already";
    next.take(0, a);  // it is kept from now on, and the other one still is
    EXPECT_EQ(next.left_behind().size(), 1u);
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_EQ(load_recipe(folder / "autosave-2.json"), a.recipe());
    next.leave_all();
    next.clear();
    const EditAutosave last(file);
    ASSERT_EQ(last.left_behind().size(), 1u);
    EXPECT_EQ(parse_recipe(last.left_behind()[0].json, "left"), b.recipe());
}

/// The system's lock must end with the program, whatever ends it.
TEST(EditAutosave, AProgramThatIsKilledLeavesWhatItHad) {
    const ScratchFolder folder;
    const std::string file = folder / "autosave.json";
    const EditHistory history = edited_marble("2");
    const pid_t child = ::fork();
    if (child == 0) {
        EditAutosave autosave(file);
        autosave.keep(history, 0.0);
        ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(EditAutosave(file).left_behind().size(), 1u);
}

TEST(EditAutosave, AFolderThatCannotBeMadeStopsNobody) {
    const ScratchFolder folder;
    write_file(folder / "file", "");
    EditHistory history(load_recipe("marble"));
    history.change(load_recipe("wood"));
    EditAutosave autosave(folder / "file/autosave.json");
    autosave.keep(history, 10.0);
    EXPECT_TRUE(autosave.left_behind().empty());
}

TEST(EditFiles, NumberedFilesReplaceNone) {
    const ScratchFolder folder;
    const std::string stem = folder / "shot";
    write_file(stem + "-001.png", "a");
    write_file(stem + "-003.png", "c");
    EXPECT_EQ(claim_numbered(stem, ".png"), stem + "-002.png");
    EXPECT_EQ(claim_numbered(stem, ".png"), stem + "-004.png");
    EXPECT_EQ(read_file_bytes(stem + "-001.png").size(), 1u);
    EXPECT_THROW(claim_numbered("/nowhere/shot", ".png"), Error);
}

TEST(EditExport, WritesWhatABakeWrites) {
    const ScratchFolder folder;
    const Recipe recipe = load_recipe("wood", {"atlas.size=64", "atlas.tries=1"});
    EditExport exports([] {});
    exports.start({"sample:cube", recipe, folder / "cube.png"});
    exports.wait();
    const auto outcome = exports.take_outcome();
    ASSERT_TRUE(outcome);
    EXPECT_FALSE(outcome->problem) << outcome->text;
    Pipeline pipeline(load_mesh("sample:cube"));
    pipeline.set_recipe(recipe);
    const Image<Rgb8> expected = pipeline.synthesize<Rgb8>(), found = read_png(folder / "cube.png");
    ASSERT_EQ(found.width(), expected.width());
    EXPECT_TRUE(std::ranges::equal(found.pixels(), expected.pixels()));
}

/// Before it is done.
TEST(EditExport, KnowsTheFilesItWillWrite) {
    const ScratchFolder folder;
    for (const char* recipe : {"wood", "forming-marble"})
        for (const std::string name : {"a.glb", "a.gltf", "a.obj", "a.png", "a.exr", "a.frag"})
            for (const bool levels : {false, true}) {
                SCOPED_TRACE(fmt::format("{} {} {}", recipe, name, levels));
                const std::string place = folder / "out";
                std::filesystem::create_directory(place);
                ExportRequest request{"sample:cube",
                                      load_recipe(recipe, {"atlas.size=32", "atlas.tries=1"}),
                                      place + "/" + name, levels};
                const bool moves = !request.recipe.animation.tracks.empty();
                if (moves && name != "a.png") continue;
                if (moves) request.recipe.animation.seconds = 0.1;
                std::vector<std::string> expected = export_files(request), found;
                (moves ? bake_frames : bake_file)(request, {}, {});
                for (const auto& entry : std::filesystem::directory_iterator(place))
                    found.push_back(entry.path().string());
                std::ranges::sort(expected);
                std::ranges::sort(found);
                EXPECT_EQ(found, expected);
                std::filesystem::remove_all(place);
            }
    EXPECT_EQ(export_files({"sample:cube", load_recipe("wood"), "a.txt"}),
              std::vector<std::string>{"a.txt"});
}

/// The message, and no file is written.
std::string refusal_of(const ScratchFolder& folder, const ExportRequest& request) {
    const std::size_t before = folder.entries();
    std::string message;
    try {
        (request.recipe.animation.tracks.empty() ? bake_file : bake_frames)(request, {}, {});
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::io) << error.what();
        message = error.what();
    }
    EXPECT_EQ(folder.entries(), before);
    return message;
}

TEST(EditExport, LeavesWhatItReadsAlone) {
    const ScratchFolder folder;
    for (const char* name : {"image.png", "out.0002.png"})
        write_png(folder / name, Image<Rgb8>(2, 2));
    write_file(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string mesh = folder / "m.obj", path = folder / "r.json";
    const auto recipe = [&](const std::string& image, const std::string& more = "") {
        return parse_recipe(R"({"texture": {"node": "image", "file": ")" + image +
                                R"("}, "atlas": {"size": 32})" + more + "}",
                            path);
    };
    ExportRequest request{mesh, recipe("image.png"), folder / "image.png"};
    request.recipe_path = path;
    EXPECT_NE(refusal_of(folder, request).find("image.png"), std::string::npos);
    request.out = folder / "image.obj";  // whose texture is the image
    EXPECT_NE(refusal_of(folder, request).find("image.png"), std::string::npos);
    request.out = mesh;
    EXPECT_NE(refusal_of(folder, request).find("m.obj"), std::string::npos);
    request.recipe = recipe("out.0002.png", R"(, "animation": {"seconds": 1, "rate": 4, "tracks": [
        {"path": "solid.scale", "keys": [[0, 1], [1, 2]]}]})");
    request.out = folder / "out.png";
    EXPECT_NE(refusal_of(folder, request).find("out.0002.png"), std::string::npos);
}

TEST(EditExport, TellsWhatIsWrong) {
    EditExport exports([] {});
    exports.start({"sample:cube", load_recipe("wood"), "/nowhere/cube.glb"});
    exports.wait();
    const auto outcome = exports.take_outcome();
    ASSERT_TRUE(outcome);
    EXPECT_TRUE(outcome->problem);
    EXPECT_NE(outcome->text.find("/nowhere"), std::string::npos);
    EXPECT_FALSE(exports.busy());
}

}  // namespace
}  // namespace burl
