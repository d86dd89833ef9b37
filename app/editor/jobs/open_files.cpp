#include "app/editor/jobs/open_files.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iterator>
#include <utility>

#include "app/base/out_of_memory.h"
#include "app/export/command_files.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/recipe/presets.h"
#include "app/surface/sample_meshes.h"
#include "atlas/read/read_mesh.h"

namespace burl {

namespace {

/// Returns the recipe's file and the image files that the recipe names.
std::vector<std::string> recipe_files(const std::string& path, const Recipe& recipe) {
    std::vector<std::string> files{recipe_file(path)};
    std::ranges::move(images_of_recipe(path, recipe), std::back_inserter(files));
    return files;
}

void read_into(FileRead& result, const std::string& mesh) {
    if (result.kind == FileKind::mesh) {
        result.files = look_at(files_of_mesh(result.path, MeshFiles::read));
        result.mesh = load_mesh(result.path);
        result.own_poses = poses_of(result.path);
        return;
    }
    if (result.kind == FileKind::pose) {
        if (is_pose_file(result.path))
            result.files = look_at(files_of_mesh(result.path, MeshFiles::read));
        result.pose = std::make_shared<const MeshPose>(load_pose(mesh, result.path));
        return;
    }
    result.files = look_at({recipe_file(result.path)});
    result.recipe = load_recipe(result.path);
    const WatchedFiles all = look_at(recipe_files(result.path, *result.recipe));
    result.files.paths = all.paths;
    result.files.stamps.insert(result.files.stamps.end(), all.stamps.begin() + 1, all.stamps.end());
}

/// Whether an open path is a file on disk rather than a sample, a preset or nothing.
bool is_file(FileKind kind, const std::string& path) {
    return kind == FileKind::recipe ? kind_of_file(path) == FileKind::recipe
                                    : !path.empty() && !is_sample_mesh(path);
}

}  // namespace

Mesh load_mesh(const std::string& path) {
    return is_sample_mesh(path) ? sample_mesh(path) : read_mesh(path);
}

FileKind kind_of_file(const std::string& path) {
    return names_recipe_file(path) ? FileKind::recipe : FileKind::mesh;
}

FileRead read_opened(const FileWish& wish) {
    const auto start = std::chrono::steady_clock::now();
    FileRead result{wish.kind, wish.path, wish.again};
    result.of_mesh = wish.mesh;
    try {
        read_into(result, wish.mesh);
    } catch (const Error& problem) {
        result.problem = problem;
    } catch (const std::exception& problem) {
        result.problem =
            Error(ExitCode::runtime, fmt::format("{}: {}", wish.path, words_of(problem)));
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

EditReader::~EditReader() {
    for (const std::future<void>& one : running_) one.wait();
}

void EditReader::read(FileWish wish) {
    std::erase_if(running_, [](const std::future<void>& one) {
        return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    const std::scoped_lock lock(mutex_);
    const std::uint64_t number = ++numbers_;
    wanted_[std::size_t(wish.kind)] = number;
    paths_[std::size_t(wish.kind)] = wish.path;
    running_.push_back(std::async(std::launch::async,
                                  [this, number, what = std::move(wish)] { run(number, what); }));
}

void EditReader::forget(FileKind kind) {
    {
        const std::scoped_lock lock(mutex_);
        wanted_[std::size_t(kind)] = 0;
        std::erase_if(done_, [&](const FileRead& read) { return read.kind == kind; });
    }
    changed_.notify_all();
}

void EditReader::run(std::uint64_t number, const FileWish& wish) {
    FileRead result = read_opened(wish);
    {
        const std::scoped_lock lock(mutex_);
        if (wanted_[std::size_t(wish.kind)] != number) return;
        wanted_[std::size_t(wish.kind)] = 0;
        done_.push_back(std::move(result));
    }
    changed_.notify_all();
    wake_();
}

std::string EditReader::reading(FileKind kind) const {
    const std::scoped_lock lock(mutex_);
    const bool waits = std::ranges::count(done_, kind, &FileRead::kind) > 0;
    return wanted_[std::size_t(kind)] == 0 && !waits ? "" : paths_[std::size_t(kind)];
}

bool EditReader::idle() const {
    const std::scoped_lock lock(mutex_);
    return nothing_wanted() && done_.empty();
}

void EditReader::wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return nothing_wanted(); });
}

std::vector<FileRead> EditReader::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(done_, {});
}

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
    watch_.watch(FileKind::recipe, file ? look_at({recipe_file(path)}) : WatchedFiles{});
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
