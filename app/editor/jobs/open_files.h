#pragma once
// The mesh, its pose and the recipe that an editor has open: they are read in the background, read
// again when they change on disk, and added to the list of recent files.
#include <functional>
#include <string>
#include <vector>

#include "app/editor/jobs/reader.h"
#include "app/editor/jobs/watch.h"
#include "app/editor/session/recent.h"

namespace burl {

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
