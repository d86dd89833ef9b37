#pragma once
// The mesh, its pose and the recipe that an editor has open: they are read beside the user
// interface, read again when somebody else changes them, and remembered. It knows neither windows
// nor pictures.
#include <functional>
#include <string>
#include <vector>

#include "app/editor/session/recent.h"
#include "app/editor/work/reader.h"
#include "app/editor/work/watch.h"

namespace burl {

/// All functions may be called by one thread.
class EditOpenFiles {
  public:
    /// `wake` is called by other threads when take() has something to do. `recent`: RecentFiles'.
    EditOpenFiles(std::function<void()> wake, std::string recent);

    /// Begins to read it; what is open stays until that is done.
    void open(const std::string& path);
    /// A pose of the mesh (app/surface/load_pose.h), and none; another mesh has none.
    void open_pose(const std::string& pose);
    void close_pose();
    /// Reads all again, as far as they are files.
    void reload();
    /// The recipe is now this file or preset, which was written or read by other means.
    void set_recipe(const std::string& path);

    /// What was read since. Of the recipe that changed on disk nothing comes while the one here
    /// `is_edited`: asks() then.
    std::vector<FileRead> take(bool is_edited);
    /// The recipe changed on disk while it was edited here; reload() or keep() is the answer.
    bool asks() const { return asks_; }
    void keep() { asks_ = false; }

    const std::string& mesh() const { return paths_[0]; }
    const std::string& recipe() const { return paths_[1]; }
    const std::string& pose() const { return paths_[2]; }
    /// What poses the mesh's file has.
    const std::vector<std::string>& own_poses() const { return own_poses_; }
    const RecentFiles& recent() const { return recent_; }
    /// What is being read or waits for take(), by kind; empty: nothing.
    std::string reading(FileKind kind) const { return reader_.reading(kind); }
    bool idle() const { return reader_.idle(); }

    /// From now on the disk is looked at twice a second.
    void watch();
    /// Waits for what is being read and looks at the disk; whether there is anything to take.
    bool settle();

  private:
    void read_changed(bool is_edited);
    void adopt(const FileRead& read);

    std::function<void()> wake_;
    std::array<std::string, file_kinds> paths_;  ///< by kind
    std::vector<std::string> own_poses_;
    bool asks_ = false;
    RecentFiles recent_;
    FileWatch watch_;
    EditReader reader_;
};

}  // namespace burl
