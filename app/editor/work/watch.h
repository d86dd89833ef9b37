#pragma once
// Files on disk that an editor shows: whether one was changed by somebody else. They are looked at
// again and again, as that works on every file system, and a change counts once the file has been
// the same for two looks, so that one which is still being written is left alone.
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

/// What an editor has opened.
enum class FileKind { mesh, recipe, pose };
inline constexpr std::size_t file_kinds = 3;

/// What tells one state of a file from another.
struct FileStamp {
    std::int64_t seconds = 0, nanoseconds = 0;  ///< when it was last written
    std::uint64_t bytes = 0, inode = 0;
    bool operator==(const FileStamp&) const = default;
};

/// A mesh is several files where it has buffers of its own, a recipe where it names images.
struct WatchedFiles {
    std::vector<std::string> paths{};
    std::vector<std::optional<FileStamp>> stamps{};  ///< nothing: not there
    bool operator==(const WatchedFiles&) const = default;
};

/// As the files are now.
WatchedFiles look_at(std::vector<std::string> paths);

/// Whether files have changed, from looks at them.
class FileChange {
  public:
    /// The state that is known; none of files that are no longer watched counts.
    explicit FileChange(WatchedFiles known = {}) : known_(known), last_(std::move(known)) {}

    const std::vector<std::string>& paths() const { return known_.paths; }
    /// True once for every state that is not the known one, when two looks in a row have found it
    /// and every file is there. It is the known one then.
    bool look(WatchedFiles now);

  private:
    WatchedFiles known_, last_;
};

/// Looks at the files of a mesh, of a recipe and of a pose. All functions may be called by any
/// thread.
class FileWatch {
  public:
    FileWatch() = default;
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// From now on these, which were in this state when they were read; none: nothing.
    void watch(FileKind kind, WatchedFiles files);
    /// Looks once; whether take() has something new.
    bool look();
    /// From now on looks twice a second, on a thread of its own that calls `wake` for news.
    void start(std::function<void()> wake,
               std::chrono::milliseconds period = std::chrono::milliseconds(500));
    /// Whether the files have changed since they were read or this was last asked.
    bool take(FileKind kind);

  private:
    void run(const std::stop_token& ending, const std::function<void()>& wake,
             std::chrono::milliseconds period);
    bool look(FileKind kind);

    std::mutex mutex_;
    std::condition_variable_any ending_;
    std::array<FileChange, file_kinds> changes_;
    std::array<std::uint64_t, file_kinds> versions_{};  ///< of what is watched
    std::array<bool, file_kinds> changed_{};
    std::jthread thread_;  ///< last: it sees all the others
};

}  // namespace burl
