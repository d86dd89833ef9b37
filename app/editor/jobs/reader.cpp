#include "app/editor/jobs/reader.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iterator>
#include <utility>

#include "app/export/command_files.h"
#include "app/surface/sample_meshes.h"
#include "atlas/read/read_mesh.h"

namespace burl {

namespace {

/// Returns the recipe's file and the image files that the recipe names.
std::vector<std::string> recipe_files(const std::string& path, const Recipe& recipe) {
    std::vector<std::string> files{path};
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
    result.files = look_at({result.path});
    result.recipe = load_recipe(result.path);
    const WatchedFiles all = look_at(recipe_files(result.path, *result.recipe));
    result.files.paths = all.paths;
    result.files.stamps.insert(result.files.stamps.end(), all.stamps.begin() + 1, all.stamps.end());
}

}  // namespace

Mesh load_mesh(const std::string& path) {
    return is_sample_mesh(path) ? sample_mesh(path) : read_mesh(path);
}

FileKind kind_of_file(const std::string& path) {
    return std::filesystem::path(path).extension() == ".json" ? FileKind::recipe : FileKind::mesh;
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
        result.problem = Error(ExitCode::runtime, fmt::format("{}: {}", wish.path, problem.what()));
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

}  // namespace burl
