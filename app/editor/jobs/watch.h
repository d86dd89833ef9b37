#pragma once
// Finds out when files that an editor has open change on disk. The files are polled, which works on
// every file system. A change counts once two looks in a row find the same state, so that a file
// that is still being written is not read.
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace burl {

/// The kinds of files that an editor opens.
enum class FileKind { mesh, recipe, pose };
inline constexpr std::size_t file_kinds = 3;

/// Attributes by which two states of a file differ.
struct FileStamp {
    std::int64_t seconds = 0, nanoseconds = 0;  ///< time of the last modification
    std::uint64_t bytes = 0, inode = 0;
    bool operator==(const FileStamp&) const = default;
};

/// The files of one mesh, recipe or pose, and their states: a glTF mesh may have buffers in files
/// of their own, and a recipe may name images.
struct WatchedFiles {
    std::vector<std::string> paths{};
    std::vector<std::optional<FileStamp>> stamps{};  ///< one per path; empty: no such file
    bool operator==(const WatchedFiles&) const = default;
};

/// Returns the files with their present states.
WatchedFiles look_at(std::vector<std::string> paths);

/// Detects changes from successive looks at the same files.
class FileChange {
  public:
    /// `known` is the state that the program has read; no paths: nothing is watched.
    explicit FileChange(WatchedFiles known = {}) : known_(known), last_(std::move(known)) {}

    const std::vector<std::string>& paths() const { return known_.paths; }
    /// Returns true if every file is there, in a state found by two looks in a row that is not the
    /// known one; the state is the known one from then on.
    bool look(WatchedFiles now);

  private:
    WatchedFiles known_, last_;
};

/// Watches the files of a mesh, of a recipe and of a pose. All functions may be called by any
/// thread.
class FileWatch {
  public:
    FileWatch() = default;
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// Watches `files`, whose stamps are those found when the files were read; no paths: nothing.
    void watch(FileKind kind, WatchedFiles files);
    /// Looks once at all files; returns whether one of the kinds changed.
    bool look();
    /// Starts a thread that looks once every `period` and calls `wake` after a change.
    void start(std::function<void()> wake,
               std::chrono::milliseconds period = std::chrono::milliseconds(500));
    /// Returns whether the `kind` files changed since they were read or since the last call.
    bool take(FileKind kind);

  private:
    void run(const std::stop_token& ending, const std::function<void()>& wake,
             std::chrono::milliseconds period);
    bool look(FileKind kind);

    // `mutex_` guards changes_, versions_ and changed_.
    std::mutex mutex_;
    std::condition_variable_any ending_;
    std::array<FileChange, file_kinds> changes_;
    std::array<std::uint64_t, file_kinds> versions_{};  ///< incremented by every watch()
    std::array<bool, file_kinds> changed_{};
    std::jthread thread_;  ///< last member: it uses all the others
};

}  // namespace burl
