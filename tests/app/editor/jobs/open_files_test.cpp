// The files that an editor has open: read beside everything else, again when they change, and
// remembered.
#include "app/editor/jobs/open_files.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "app/base/atomic_file.h"
#include "app/surface/sample_meshes.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
constexpr const char* open_files_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

TEST(EditReader, ReadsMeshesAndRecipes) {
    const ScratchFolder folder;
    write_file(folder / "wood.json", to_json(load_recipe("wood")));
    std::atomic<int> woken = 0;
    EditReader reader([&] { ++woken; });
    reader.read({FileKind::mesh, "sample:cube"});
    reader.read({FileKind::recipe, folder / "wood.json"});
    reader.wait();
    std::vector<FileRead> read = reader.take();
    ASSERT_EQ(read.size(), 2u);
    std::ranges::sort(read, {}, &FileRead::kind);
    ASSERT_TRUE(read[0].mesh);
    EXPECT_EQ(read[0].mesh->triangles, sample_mesh("sample:cube").triangles);
    EXPECT_TRUE(read[0].files.paths.empty());
    ASSERT_TRUE(read[1].recipe);
    EXPECT_EQ(*read[1].recipe, load_recipe("wood"));
    EXPECT_EQ(read[1].files, look_at({folder / "wood.json"}));
    EXPECT_TRUE(reader.idle());
    EXPECT_TRUE(reader.take().empty());
}

TEST(EditReader, TellsTheReadersSentence) {
    const ScratchFolder folder;
    write_file(folder / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    EditReader reader([] {});
    reader.read({FileKind::mesh, folder / "bad.obj"});
    reader.wait();
    const std::vector<FileRead> read = reader.take();
    ASSERT_EQ(read.size(), 1u);
    ASSERT_TRUE(read[0].problem);
    EXPECT_EQ(read[0].problem->code(), ExitCode::invalid_file);
    try {
        load_mesh(folder / "bad.obj");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_STREQ(read[0].problem->what(), error.what());
    }
}

TEST(EditReader, OnlyTheLastOfAKindIsHeardOf) {
    const ScratchFolder folder;
    write_file(folder / "one.obj", triangle);
    EditReader reader([] {});
    for (int i = 0; i < 20; ++i) reader.read({FileKind::mesh, "sample:teapot"});
    reader.read({FileKind::mesh, folder / "one.obj"});
    reader.wait();
    const std::vector<FileRead> read = reader.take();
    ASSERT_FALSE(read.empty());
    EXPECT_EQ(read.back().path, folder / "one.obj");
    EXPECT_EQ(reader.reading(FileKind::mesh), "");
}

/// An editor that asks between the end of reading and take() would otherwise take its mesh for
/// open.
TEST(EditReader, StillReadsWhatNobodyHasTaken) {
    EditReader reader([] {});
    reader.read({FileKind::mesh, "sample:cube"});
    reader.wait();
    EXPECT_EQ(reader.reading(FileKind::mesh), "sample:cube");
    EXPECT_EQ(reader.reading(FileKind::recipe), "");
    EXPECT_EQ(reader.take().size(), 1U);
    EXPECT_EQ(reader.reading(FileKind::mesh), "");
}

class EditOpenFilesTest : public testing::Test {
  protected:
    std::vector<FileRead> settled(bool is_edited = false) {
        std::vector<FileRead> all;
        while (files.settle())
            for (FileRead& one : files.take(is_edited)) all.push_back(std::move(one));
        return all;
    }
    void save(const Recipe& recipe) { write_file(folder / "r.json", to_json(recipe)); }

    ScratchFolder folder;
    EditOpenFiles files{[] {}, folder / "recent"};
};

TEST_F(EditOpenFilesTest, AMeshThatChangesIsReadAgain) {
    write_file(folder / "m.obj", triangle);
    files.open(folder / "m.obj");
    ASSERT_EQ(settled().size(), 1u);
    EXPECT_EQ(files.mesh(), folder / "m.obj");
    EXPECT_TRUE(settled().empty());
    write_file(folder / "m.obj", open_files_square);
    const auto read = settled(true);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_TRUE(read[0].again);
    EXPECT_EQ(read[0].mesh->triangles.size(), 2u);
}

TEST_F(EditOpenFilesTest, AHalfWrittenFileIsTriedAgain) {
    write_file(folder / "m.obj", triangle);
    files.open(folder / "m.obj");
    settled();
    write_file(folder / "m.obj", "v 0 0 0\nf 1 2");
    auto read = settled();
    ASSERT_EQ(read.size(), 1u);
    EXPECT_TRUE(read[0].problem);
    EXPECT_EQ(files.mesh(), folder / "m.obj");
    EXPECT_TRUE(settled().empty());  // once is enough
    write_file(folder / "m.obj", open_files_square);
    read = settled();
    ASSERT_EQ(read.size(), 1u);
    EXPECT_TRUE(read[0].mesh);
}

TEST_F(EditOpenFilesTest, ARecipeThatIsEditedIsNotReplaced) {
    save(load_recipe("wood"));
    files.open(folder / "r.json");
    ASSERT_EQ(settled().size(), 1u);
    save(load_recipe("marble"));
    EXPECT_TRUE(settled(true).empty());
    EXPECT_TRUE(files.asks());
    files.keep();
    EXPECT_TRUE(settled(true).empty());
    EXPECT_FALSE(files.asks());
    files.reload();
    const auto read = settled(true);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(*read[0].recipe, load_recipe("marble"));
    save(load_recipe("wood"));
    EXPECT_EQ(settled(false).size(), 1u);
}

TEST_F(EditOpenFilesTest, ItsOwnFilesAreNoNewsAndPresetsAreNotWatched) {
    save(load_recipe("wood"));
    files.set_recipe(folder / "r.json");
    save(load_recipe("marble"));
    files.set_recipe(folder / "r.json");
    EXPECT_TRUE(settled().empty());
    files.set_recipe("marble");
    save(load_recipe("wood"));
    EXPECT_TRUE(settled().empty());
    files.reload();  // nothing of it is a file
    EXPECT_TRUE(settled().empty());
}

TEST_F(EditOpenFilesTest, WhatCannotBeReadIsNotOpen) {
    files.open(folder / "missing.obj");
    const auto read = settled();
    ASSERT_EQ(read.size(), 1u);
    EXPECT_TRUE(read[0].problem);
    EXPECT_EQ(files.mesh(), "");
    EXPECT_TRUE(files.recent().paths().empty());
}

TEST(RecentFiles, AreTheLastTenWithoutRepeats) {
    const ScratchFolder folder;
    const std::string list = folder / "state/recent";
    RecentFiles recent(list);
    for (int i = 0; i < 12; ++i) {
        const std::string file = folder / fmt::format("{}.obj", i);
        write_file(file, triangle);
        recent.add(file);
    }
    recent.add(folder / "5.obj");
    ASSERT_EQ(recent.paths().size(), most_recent_files);
    EXPECT_EQ(std::filesystem::path(recent.paths()[0]).filename(), "5.obj");
    EXPECT_EQ(std::filesystem::path(recent.paths()[1]).filename(), "11.obj");
    EXPECT_EQ(std::filesystem::path(recent.paths().back()).filename(), "2.obj");
    EXPECT_EQ(RecentFiles(list).paths(), recent.paths());
}

TEST(RecentFiles, KeepsWhatAnotherEditorHasOpened) {
    const ScratchFolder folder;
    write_file(folder / "a.obj", triangle);
    write_file(folder / "b.obj", triangle);
    RecentFiles one(folder / "recent"), other(folder / "recent");
    one.add(folder / "a.obj");
    other.add(folder / "b.obj");
    other.add("sample:teapot");
    other.add(folder / "missing.obj");
    EXPECT_EQ(RecentFiles(folder / "recent").paths().size(), 2u);
}

TEST(RecentFiles, AFolderThatCannotBeMadeStopsNobody) {
    const ScratchFolder folder;
    write_file(folder / "file", "");
    write_file(folder / "a.obj", triangle);
    RecentFiles recent(folder / "file/recent");
    recent.add(folder / "a.obj");
    EXPECT_EQ(recent.paths().size(), 1u);
}

}  // namespace
}  // namespace burl
