#pragma once
// The mesh, its pose and the recipe that an editor has open: they are read in the background, read
// again when they change on disk, and added to the list of recent files.
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
#include "app/editor/session/recent.h"
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

/// The open files by kind, without windows or textures. All functions may be called by one thread.
class EditOpenFiles {
  public:
    /// `wake` is called by other threads when take() has something to do. `recent` is the path of
    /// the file of recent files (RecentFiles).
    EditOpenFiles(std::function<void()> wake, std::string recent);

    /// Begins to read a mesh or a recipe, by its extension; the open file stays until then.
    void open(const std::string& path);
    /// Begins to read a pose of the mesh (app/surface/sample_meshes.h).
    void open_pose(const std::string& pose);
    /// Drops the pose; opening another mesh does that too.
    void close_pose();
    /// Reads the open mesh and recipe again where they are files (samples and presets are not).
    void reload();
    /// Sets the path of the recipe, a file or preset, that the caller wrote or read itself.
    void set_recipe(const std::string& path);

    /// Returns the files read since the last call. While the user's recipe `is_edited`, a recipe
    /// that changed on disk is not read: asks() becomes true instead.
    std::vector<FileRead> take(bool is_edited);
    /// Whether the recipe changed on disk while it was edited here; reload() or keep() answers.
    bool asks() const { return asks_; }
    /// Keeps the edited recipe.
    void keep() { asks_ = false; }

    const std::string& mesh() const { return paths_[0]; }
    const std::string& recipe() const { return paths_[1]; }
    const std::string& pose() const { return paths_[2]; }
    /// The names of the poses that the mesh's file contains.
    const std::vector<std::string>& own_poses() const { return own_poses_; }
    const RecentFiles& recent() const { return recent_; }
    /// The path of the `kind` file that is being read or waits for take(); empty: none.
    std::string reading(FileKind kind) const { return reader_.reading(kind); }
    /// Whether no file is being read or waits for take().
    bool idle() const { return reader_.idle(); }

    /// Starts to look for changes on disk, twice a second.
    void watch();
    /// Waits for files being read and looks for changes twice. Returns whether take() has
    /// something.
    bool settle();

  private:
    void read_changed(bool is_edited);
    void adopt(const FileRead& read);

    std::function<void()> wake_;
    std::array<std::string, file_kinds> paths_;  ///< indexed by FileKind; empty: none
    std::vector<std::string> own_poses_;
    bool asks_ = false;
    RecentFiles recent_;
    FileWatch watch_;
    EditReader reader_;
};

}  // namespace burl
