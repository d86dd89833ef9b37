// The editor's files: what its browser lists, what survives a crash, and that an export is the
// bytes of a bake.
#include "app/edit_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/atomic_file.h"
#include "app/edit_autosave.h"
#include "app/edit_export.h"
#include "app/edit_reader.h"
#include "app/file_bytes.h"
#include "app/image_io.h"
#include "app/pipeline.h"
#include "tests/app/scratch_folder.h"

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

TEST(EditAutosave, SurvivesUntilSavedOrEndedWell) {
    const ScratchFolder folder;
    const std::string file = folder / "state/autosave.json";
    EditHistory history(load_recipe("marble"));
    EditAutosave autosave(file);
    autosave.keep(history, 0.0);
    EXPECT_FALSE(autosave.left_behind());
    history.change(load_recipe("marble", {"solid.scale=2"}));
    autosave.keep(history, 10.0);
    const auto left = EditAutosave(file).left_behind();
    ASSERT_TRUE(left);
    EXPECT_EQ(parse_recipe(*left, "left"), history.recipe());
    history.change(load_recipe("marble", {"solid.scale=3"}));
    autosave.keep(history, 10.5);  // too soon
    EXPECT_EQ(EditAutosave(file).left_behind(), left);
    history.mark_saved();
    autosave.keep(history, 11.0);
    EXPECT_FALSE(EditAutosave(file).left_behind());
}

TEST(EditAutosave, AFolderThatCannotBeMadeStopsNobody) {
    const ScratchFolder folder;
    write_file(folder / "file", "");
    EditHistory history(load_recipe("marble"));
    history.change(load_recipe("wood"));
    EditAutosave autosave(folder / "file/autosave.json");
    autosave.keep(history, 10.0);
    EXPECT_FALSE(autosave.left_behind());
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
