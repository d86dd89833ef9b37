#pragma once
// Meshes and recipes are read beside the user interface, which goes on with what it has until they
// are there.
#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/work/watch.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"
#include "atlas/mesh/mesh.h"
#include "atlas/read/pose.h"

namespace burl {

/// A mesh file, or "sample:NAME". Throws Error.
Mesh load_mesh(const std::string& path);

/// What the file names: .json is a recipe.
FileKind kind_of_file(const std::string& path);

/// A file that was read, or why it was not.
struct FileRead {
    FileKind kind = FileKind::mesh;
    std::string path{};
    bool again = false;  ///< it was open already
    std::optional<Error> problem{};
    std::optional<Mesh> mesh{};  ///< one of the three, unless there is a problem
    std::optional<Recipe> recipe{};
    std::shared_ptr<const MeshPose> pose{};
    std::string of_mesh{};                 ///< of a pose
    std::vector<std::string> own_poses{};  ///< of a mesh: what its file has
    WatchedFiles files{};                  ///< as they were before they were read
    double seconds = 0.0;
};

/// What to read. A pose may be one of its mesh's own (app/surface/load_pose.h).
struct FileWish {
    FileKind kind = FileKind::mesh;
    std::string path{};
    bool again = false;  ///< it is open already
    std::string mesh{};  ///< of a pose: its mesh
};

/// Reads one. Never throws Error.
FileRead read_opened(const FileWish& wish);

/// All functions may be called by one thread.
class EditReader {
  public:
    /// `wake` is called by another thread when take() has something.
    explicit EditReader(std::function<void()> wake) : wake_(std::move(wake)) {}
    EditReader(const EditReader&) = delete;
    EditReader& operator=(const EditReader&) = delete;
    /// Waits for what is under way.
    ~EditReader();

    /// Begins at once. One of that kind that is still being read is not wanted any more: nobody
    /// hears of it.
    void read(FileWish wish);
    /// One of that kind that is being read is not wanted any more.
    void forget(FileKind kind);
    /// What is being read or waits for take(), by kind; empty: nothing.
    std::string reading(FileKind kind) const;
    /// Nothing is being read, and take() has had all.
    bool idle() const;
    /// Until nothing is being read.
    void wait() const;
    /// What has been read since, in the order in which that ended.
    std::vector<FileRead> take();

  private:
    bool nothing_wanted() const { return std::ranges::count(wanted_, 0U) == file_kinds; }
    void run(std::uint64_t number, const FileWish& wish);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::uint64_t numbers_ = 0;
    std::array<std::uint64_t, file_kinds>
        wanted_{};  ///< by kind, the newest that is under way; 0: none
    std::array<std::string, file_kinds> paths_;
    std::vector<FileRead> done_;
    std::vector<std::future<void>> running_;
};

}  // namespace burl
