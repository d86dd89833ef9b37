// Files that change on disk: a change is told once, when it rests, and what is known already never.
#include "app/editor/jobs/watch.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>

#include "app/base/atomic_file.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

WatchedFiles state(std::optional<std::int64_t> seconds, std::uint64_t bytes = 1) {
    std::optional<FileStamp> stamp;
    if (seconds) stamp = FileStamp{*seconds, 0, bytes, 7};
    return {{"a.obj"}, {stamp}};
}

TEST(FileChange, IsToldOnceWhenItRests) {
    FileChange change(state(1));
    EXPECT_FALSE(change.look(state(1)));
    EXPECT_FALSE(change.look(state(2)));  // just now
    EXPECT_TRUE(change.look(state(2)));
    EXPECT_FALSE(change.look(state(2)));
    EXPECT_FALSE(change.look(state(2)));
}

TEST(FileChange, AFileThatIsBeingWrittenIsLeftAlone) {
    FileChange change(state(1));
    for (std::uint64_t bytes = 10; bytes < 20; ++bytes) EXPECT_FALSE(change.look(state(2, bytes)));
    EXPECT_TRUE(change.look(state(2, 19)));
}

TEST(FileChange, AFileThatIsGoneIsWaitedFor) {
    FileChange change(state(1));
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(change.look(state({})));
    EXPECT_FALSE(change.look(state(3)));
    EXPECT_TRUE(change.look(state(3)));
    EXPECT_FALSE(change.look(state({})));
    EXPECT_FALSE(change.look(state(3)));
    EXPECT_FALSE(change.look(state(3)));  // it is what it was
}

TEST(FileWatch, TellsOfEveryFileOfAKindAndOnlyOfThat) {
    const ScratchFolder folder;
    write_file(folder / "a.gltf", "1");
    write_file(folder / "a.bin", "1");
    write_file(folder / "r.json", "{}");
    FileWatch watch;
    watch.watch(FileKind::mesh, look_at({folder / "a.gltf", folder / "a.bin"}));
    watch.watch(FileKind::recipe, look_at({folder / "r.json"}));
    EXPECT_FALSE(watch.look());
    EXPECT_FALSE(watch.look());
    write_file(folder / "a.bin", "22");
    EXPECT_FALSE(watch.look());
    EXPECT_TRUE(watch.look());
    EXPECT_FALSE(watch.take(FileKind::recipe));
    EXPECT_TRUE(watch.take(FileKind::mesh));
    EXPECT_FALSE(watch.take(FileKind::mesh));
}

TEST(FileWatch, WhatOneWroteOneselfIsNoNews) {
    const ScratchFolder folder;
    write_file(folder / "r.json", "{}");
    FileWatch watch;
    watch.watch(FileKind::recipe, look_at({folder / "r.json"}));
    write_file(folder / "r.json", "{ }");
    EXPECT_FALSE(watch.look());
    watch.watch(FileKind::recipe, look_at({folder / "r.json"}));
    EXPECT_FALSE(watch.look());
    EXPECT_FALSE(watch.look());
    EXPECT_FALSE(watch.take(FileKind::recipe));
}

TEST(FileWatch, LooksByItselfAndWakes) {
    const ScratchFolder folder;
    write_file(folder / "r.json", "{}");
    std::atomic<bool> woken = false;
    FileWatch watch;
    watch.watch(FileKind::recipe, look_at({folder / "r.json"}));
    watch.start([&] { woken = true; }, std::chrono::milliseconds(1));
    write_file(folder / "r.json", "{ }");
    while (!woken) std::this_thread::yield();
    EXPECT_TRUE(watch.take(FileKind::recipe));
}

}  // namespace
}  // namespace burl
