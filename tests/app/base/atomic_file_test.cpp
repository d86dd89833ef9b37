// Outputs are whole or absent: every way of failing leaves the folder as it was.
#include "app/base/atomic_file.h"

#include <csignal>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "atlas/base/error.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

template <class Action>
std::string io_message(Action action) {
    try {
        action();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::io);
        return e.what();
    }
    return "no error";
}

/// Files may not grow past `bytes` while this lives: a full disk, without mounting one.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*old_handler_)(int) = nullptr;
};

TEST(AtomicFile, BytesWrittenBeforeAreReplacedWhereverTheyAre) {
    const ScratchFolder folder;
    const std::string path = folder / "out.txt";
    AtomicFile file(path);
    const std::string large(1u << 20, 'x');
    file.write("head....");
    file.write(large);
    file.write("tail");
    const std::string number = "1234";
    file.overwrite(4, {reinterpret_cast<const std::uint8_t*>(number.data()), number.size()});
    file.overwrite(8 + large.size(), {reinterpret_cast<const std::uint8_t*>("T"), 1});
    file.write(" and more");
    file.commit();
    EXPECT_EQ(content(path), "head1234" + large + "Tail and more");
}

TEST(AtomicFile, NothingShowsBeforeCommitAndAllAfter) {
    const ScratchFolder folder;
    const std::string path = folder / "out.txt";
    AtomicFile file(path);
    std::string expected;
    for (int i = 0; i < 40000; ++i) {
        const std::string piece = std::to_string(i) + "\n";
        file.write(piece);
        expected += piece;
    }
    const std::string big(1u << 20, 'x');
    file.write(big);
    expected += big;
    EXPECT_FALSE(std::filesystem::exists(path));
    file.commit();
    EXPECT_EQ(content(path), expected);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, ReplacesAnOldFileAndKeepsItsPermissions) {
    const ScratchFolder folder;
    const std::string path = folder / "out.txt";
    std::ofstream(path) << "old";
    ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
    {
        AtomicFile file(path);
        file.write("new");
        EXPECT_EQ(content(path), "old");
        file.commit();
    }
    EXPECT_EQ(content(path), "new");
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(AtomicFile, NewFilesGetTheUmasksPermissions) {
    const ScratchFolder folder;
    const mode_t before = ::umask(022);
    write_file(folder / "out.txt", "x");
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat((folder / "out.txt").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0644u);
}

TEST(AtomicFile, NamedTemporariesBehaveAlike) {
    const ScratchFolder folder;
    const std::string path = folder / "out.txt";
    {
        AtomicFile file(path, Temporary::named), rival(path, Temporary::named);
        EXPECT_EQ(folder.entries(), 2u) << "hidden names from the start, one each";
        file.write("new");
        file.commit();
        EXPECT_EQ(content(path), "new");
        const FileSizeLimit limit(100);
        const std::string message = io_message([&] {
            rival.write(std::string(1000, 'x'));
            rival.commit();
        });
        EXPECT_NE(message.find(path), std::string::npos) << message;
    }
    EXPECT_EQ(content(path), "new");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, LinksAreFollowed) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "sub");
    std::ofstream(folder / "sub/real.txt") << "old";
    std::filesystem::create_symlink("sub/real.txt", folder / "link.txt");
    write_file(folder / "link.txt", "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(content(folder / "sub/real.txt"), "new");
}

TEST(AtomicFile, AbandonedFilesVanish) {
    const ScratchFolder folder;
    std::ofstream(folder / "out.txt") << "old";
    {
        AtomicFile file(folder / "out.txt");
        file.write("half of the new con");
        file.finish();  // complete, but never committed
        EXPECT_EQ(folder.entries(), 1u) << "no name before the last moment";
    }
    EXPECT_EQ(content(folder / "out.txt"), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, FullDiskLeavesTheOldFile) {
    const ScratchFolder folder;
    const std::string path = folder / "out.txt";
    std::ofstream(path) << "old";
    const std::string big(3u << 20, 'x');
    std::string message;
    {
        const FileSizeLimit limit(1u << 20);
        message = io_message([&] { write_file(path, big); });
    }
    EXPECT_NE(message.find(path), std::string::npos) << message;
    EXPECT_NE(message.find("File too large"), std::string::npos) << message;
    EXPECT_EQ(content(path), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, AGroupIsWrittenWholeOrNotAtAll) {
    const ScratchFolder folder;
    const auto write_group = [&](std::size_t size_of_second) {
        std::vector<AtomicFile> group;
        for (const char* name : {"a.png", "a.mtl", "a.obj"}) group.emplace_back(folder / name);
        group[0].write("picture");
        group[1].write("material");
        group[2].write(std::string(size_of_second, 'v'));
        commit_together(group);
    };
    {
        const FileSizeLimit limit(1000);  // smaller than the buffer: it fails as the file is closed
        EXPECT_NE(io_message([&] { write_group(5000); }).find("a.obj"), std::string::npos);
    }
    EXPECT_EQ(folder.entries(), 0u);
    std::ofstream(folder / "a.png") << "old";
    {
        const FileSizeLimit limit(1000);
        EXPECT_NE(io_message([&] { write_group(5000); }).find("a.obj"), std::string::npos);
    }
    EXPECT_EQ(content(folder / "a.png"), "old") << "nothing is renamed before all is complete";
    write_group(5000);
    EXPECT_EQ(folder.entries(), 3u);
    EXPECT_EQ(content(folder / "a.mtl"), "material");
}

TEST(AtomicFile, AGroupWhoseRenameFailsLeavesNoNewFile) {
    const ScratchFolder folder;
    std::vector<AtomicFile> group;
    for (const char* name : {"a.png", "a.obj"}) group.emplace_back(folder / name);
    std::filesystem::create_directory(folder / "a.obj");  // appears while we work
    EXPECT_NE(io_message([&] { commit_together(group); }).find("a.obj"), std::string::npos);
    group.clear();
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, AGroupWhoseRenameFailsGivesOldFilesBack) {
    const ScratchFolder folder;
    std::ofstream(folder / "a.png") << "old picture";
    {
        std::vector<AtomicFile> group;
        for (const char* name : {"a.png", "a.mtl", "a.obj"}) group.emplace_back(folder / name);
        group[0].write("new picture");
        std::filesystem::create_directory(folder / "a.obj");  // appears while we work
        EXPECT_NE(io_message([&] { commit_together(group); }).find("a.obj"), std::string::npos);
    }
    EXPECT_EQ(content(folder / "a.png"), "old picture");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.mtl"));
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(AtomicFile, AGroupThatReplacesFilesLeavesNothingElse) {
    const ScratchFolder folder;
    for (const char* name : {"a.png", "a.obj"}) std::ofstream(folder / name) << "old";
    for (const char* text : {"new", "newer"}) {
        std::vector<AtomicFile> group;
        for (const char* name : {"a.png", "a.obj"}) group.emplace_back(folder / name).write(text);
        const std::vector<CommittedFile> committed = commit_together(group);
        EXPECT_EQ(file_there(folder / "a.obj"), committed[1]);
        for (const char* name : {"a.png", "a.obj"}) EXPECT_EQ(content(folder / name), text);
        EXPECT_EQ(folder.entries(), 2u);
    }
}

TEST(AtomicFile, AFileMadeMeanwhileIsReplaced) {
    const ScratchFolder folder;
    AtomicFile file(folder / "out.txt");
    file.write("ours");
    std::ofstream(folder / "out.txt") << "theirs";
    file.commit();
    EXPECT_EQ(content(folder / "out.txt"), "ours");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, ALinkToItselfIsNoTarget) {
    const ScratchFolder folder;
    std::filesystem::create_symlink("out.txt", folder / "out.txt");
    EXPECT_NE(io_message([&] { write_file(folder / "out.txt", "x"); }).find("out.txt"),
              std::string::npos);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "out.txt"));
}

TEST(AtomicFile, WhatWasCommittedIsToldFromItsTwin) {
    const ScratchFolder folder;
    const std::string path = folder / "out.txt";
    AtomicFile ours(path), theirs(path);
    ours.write("ours..");
    theirs.write("theirs");
    const CommittedFile committed = ours.commit();
    EXPECT_EQ(file_there(path), committed);
    theirs.commit();
    // Of the same time, as two runs within one tick of the clock are.
    const timespec time{committed.seconds, committed.nanoseconds}, times[] = {time, time};
    ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
    const auto now = file_there(path);
    ASSERT_TRUE(now);
    EXPECT_EQ(now->bytes, committed.bytes);
    EXPECT_EQ(now->nanoseconds, committed.nanoseconds);
    EXPECT_NE(now, committed);
}

TEST(AtomicFile, BadTargetsAreNamedAtOnce) {
    const ScratchFolder folder;
    for (const std::string& path :
         {folder.path(), folder / "missing/out.txt", std::string("/dev/full")}) {
        EXPECT_NE(io_message([&] { AtomicFile file(path); }).find(path), std::string::npos);
    }
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(AtomicFile, NoPermissionIsNamed) {
    const ScratchFolder folder;
    std::filesystem::permissions(
        folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const uid_t user = ::geteuid();
    const bool root = user == 0 && ::seteuid(65534) == 0;  // root may write anywhere
    const std::string message = io_message([&] { AtomicFile file(folder / "out.txt"); });
    if (root) {
        ASSERT_EQ(::seteuid(user), 0);
    }
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    EXPECT_NE(message.find("Permission denied"), std::string::npos) << message;
}

TEST(AtomicFile, AKilledRunLeavesTheOldFile) {
    const ScratchFolder folder;
    std::ofstream(folder / "out.txt") << "old";
    const pid_t child = ::fork();
    if (child == 0) {
        AtomicFile file(folder / "out.txt");
        file.write(std::string(1u << 20, 'x'));
        ::raise(SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(content(folder / "out.txt"), "old");
    // One more entry is allowed only where the file system has no nameless files.
    EXPECT_LE(folder.entries(), 2u);
}

TEST(AtomicFile, WhatAKilledRunLeftIsRemovedByTheNext) {
    const ScratchFolder folder;
    const std::string path = folder / "out.txt";
    for (const bool replaces : {false, true}) {
        if (replaces) std::ofstream(path) << "old";
        const pid_t child = ::fork();
        if (child == 0) {
            AtomicFile file(path, Temporary::named);
            ::raise(SIGKILL);
        }
        ASSERT_EQ(::waitpid(child, nullptr, 0), child);
        EXPECT_EQ(folder.entries(), replaces ? 2u : 1u) << "nobody could clean up";
        write_file(path, "new");
        EXPECT_EQ(folder.entries(), 1u);
        EXPECT_EQ(content(path), "new");
        std::filesystem::remove(path);
    }
    // Whatever their numbers: the run before the last may have had the first.
    for (const char* left : {".out.txt.1.burl-tmp", ".out.txt.15.burl-tmp"})
        std::ofstream(folder / left) << "half";
    write_file(path, "new");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, SignalsRemoveTemporaryNamesAndEndTheProgram) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const ScratchFolder folder;
        const pid_t child = ::fork();
        if (child == 0) {
            clean_up_on_signals();
            AtomicFile first(folder / "a.txt", Temporary::named),
                second(folder / "b.txt", Temporary::named);
            first.write("x");
            ::kill(::getpid(), signal);
            for (;;) ::pause();
        }
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
        EXPECT_EQ(folder.entries(), 0u) << signal;
    }
}

TEST(AtomicFile, IgnoredSignalsStayIgnored) {
    const ScratchFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGHUP, SIG_IGN);
        clean_up_on_signals();
        ::kill(::getpid(), SIGHUP);
        write_file(folder / "a.txt", "done");
        sigset_t waiting;
        ::pthread_sigmask(SIG_BLOCK, nullptr, &waiting);
        const auto waits = [&](int signal) { return ::sigismember(&waiting, signal) == 1; };
        ::_exit(waits(SIGINT) && waits(SIGTERM) && !waits(SIGHUP) ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_EQ(content(folder / "a.txt"), "done");
}

}  // namespace
}  // namespace burl
