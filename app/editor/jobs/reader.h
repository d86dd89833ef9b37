#pragma once
// Meshes, poses and recipes are read in the background; the editor goes on with what it has until
// they are there.
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

#include "app/editor/jobs/watch.h"
#include "app/recipe/recipe.h"
#include "atlas/base/error.h"
#include "atlas/mesh/mesh.h"
#include "atlas/read/pose.h"

namespace burl {

/// Reads a mesh file or makes "sample:NAME". Throws Error.
Mesh load_mesh(const std::string& path);

/// Returns recipe for the extension .json, mesh for any other.
FileKind kind_of_file(const std::string& path);

/// A file that was read, or the reason why it could not be read.
struct FileRead {
    FileKind kind = FileKind::mesh;
    std::string path{};
    bool again = false;  ///< whether the same file was open already
    std::optional<Error> problem{};
    /// The content of the file: one of mesh, recipe and pose, as `kind` says; none after a problem.
    std::optional<Mesh> mesh{};
    std::optional<Recipe> recipe{};
    std::shared_ptr<const MeshPose> pose{};
    std::string of_mesh{};                 ///< for a pose, the path of its mesh
    std::vector<std::string> own_poses{};  ///< for a mesh, the names of the poses in its file
    WatchedFiles files{};                  ///< the files and their states before they were read
    double seconds = 0.0;                  ///< time that reading took
};

/// A request to read a file; the path of a pose may name one of its mesh's own
/// (app/surface/sample_meshes.h).
struct FileWish {
    FileKind kind = FileKind::mesh;
    std::string path{};
    bool again = false;  ///< whether the file is open already
    std::string mesh{};  ///< for a pose, the path of its mesh
};

/// Reads a file; problems are reported in the result. Never throws Error.
FileRead read_opened(const FileWish& wish);

/// Reads files in the background, at most one wanted per kind. All functions may be called by one
/// thread.
class EditReader {
  public:
    /// `wake` is called by another thread when take() has something.
    explicit EditReader(std::function<void()> wake) : wake_(std::move(wake)) {}
    EditReader(const EditReader&) = delete;
    EditReader& operator=(const EditReader&) = delete;
    /// Waits for all files being read.
    ~EditReader();

    /// Begins to read at once; an older read of the same kind is discarded.
    void read(FileWish wish);
    /// Discards the `kind` file that is being read or waits for take().
    void forget(FileKind kind);
    /// The path of the `kind` file that is being read or waits for take(); empty: none.
    std::string reading(FileKind kind) const;
    /// Whether no file is being read or waits for take().
    bool idle() const;
    /// Blocks until no file is being read.
    void wait() const;
    /// Returns and removes the files read, in the order in which reading ended.
    std::vector<FileRead> take();

  private:
    bool nothing_wanted() const { return std::ranges::count(wanted_, 0U) == file_kinds; }
    void run(std::uint64_t number, const FileWish& wish);

    std::function<void()> wake_;
    // `mutex_` guards numbers_, wanted_, paths_ and done_; `changed_` is notified when wanted_
    // changes.
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::uint64_t numbers_ = 0;
    std::array<std::uint64_t, file_kinds>
        wanted_{};  ///< by kind, the number of the newest read under way; 0: none
    std::array<std::string, file_kinds> paths_;
    std::vector<FileRead> done_;
    /// Reads under way, discarded ones included; the calling thread's alone.
    std::vector<std::future<void>> running_;
};

}  // namespace burl
