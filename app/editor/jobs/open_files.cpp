#include "app/editor/jobs/open_files.h"

#include <utility>

#include "app/surface/sample_meshes.h"

namespace burl {

namespace {

/// Whether an open path is a file on disk rather than a sample, a preset or nothing.
bool is_file(FileKind kind, const std::string& path) {
    return kind == FileKind::recipe ? kind_of_file(path) == FileKind::recipe
                                    : !path.empty() && !is_sample_mesh(path);
}

}  // namespace

EditOpenFiles::EditOpenFiles(std::function<void()> wake, std::string recent)
    : wake_(std::move(wake)), recent_(std::move(recent)), reader_(wake_) {}

void EditOpenFiles::open(const std::string& path) {
    reader_.read({kind_of_file(path), path});
}

void EditOpenFiles::open_pose(const std::string& pose) {
    reader_.read({FileKind::pose, pose, false, mesh()});
}

void EditOpenFiles::close_pose() {
    paths_[std::size_t(FileKind::pose)].clear();
    watch_.watch(FileKind::pose, {});
    reader_.forget(FileKind::pose);
}

void EditOpenFiles::reload() {
    asks_ = false;
    for (const FileKind kind : {FileKind::mesh, FileKind::recipe})
        if (const std::string& path = paths_[std::size_t(kind)]; is_file(kind, path))
            reader_.read({kind, path, true});
}

void EditOpenFiles::set_recipe(const std::string& path) {
    paths_[std::size_t(FileKind::recipe)] = path;
    asks_ = false;
    const bool file = is_file(FileKind::recipe, path);
    watch_.watch(FileKind::recipe, file ? look_at({path}) : WatchedFiles{});
    if (file) recent_.add(path);
}

/// Reads the files that changed on disk: mesh and pose always, as they have no edits to lose, the
/// recipe unless it is edited.
void EditOpenFiles::read_changed(bool is_edited) {
    if (watch_.take(FileKind::mesh)) reader_.read({FileKind::mesh, mesh(), true});
    if (watch_.take(FileKind::pose) && !pose().empty())
        reader_.read({FileKind::pose, pose(), true, mesh()});
    if (!watch_.take(FileKind::recipe)) return;
    asks_ = is_edited;
    if (!is_edited) reader_.read({FileKind::recipe, recipe(), true});
}

/// Makes a file that was read the open one. A file that cannot be read is not adopted; the open one
/// stays watched and is read again at its next change.
void EditOpenFiles::adopt(const FileRead& read) {
    if (read.problem) return;
    paths_[std::size_t(read.kind)] = read.path;
    watch_.watch(read.kind, read.files);
    if (read.kind == FileKind::recipe) asks_ = false;
    if (!read.again && read.kind != FileKind::pose) recent_.add(read.path);
    if (read.kind != FileKind::mesh) return;
    own_poses_ = read.own_poses;
    const std::string pose = paths_[std::size_t(FileKind::pose)];
    if (!read.again) close_pose();
    if (read.again && !pose.empty()) reader_.read({FileKind::pose, pose, true, mesh()});
}

std::vector<FileRead> EditOpenFiles::take(bool is_edited) {
    read_changed(is_edited);
    std::vector<FileRead> read = reader_.take(), taken;
    for (FileRead& one : read) {
        // A pose of a mesh that is no longer open.
        if (one.kind == FileKind::pose && one.of_mesh != mesh()) continue;
        adopt(one);
        taken.push_back(std::move(one));
    }
    return taken;
}

void EditOpenFiles::watch() {
    watch_.start(wake_);
}

bool EditOpenFiles::settle() {
    bool news = !reader_.idle();
    reader_.wait();
    for (int look = 0; look < 2; ++look) news |= watch_.look();
    return news;
}

}  // namespace burl
