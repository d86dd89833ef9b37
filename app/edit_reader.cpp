#include "app/edit_reader.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <utility>

#include "app/sample_meshes.h"
#include "app/up_to_date.h"
#include "atlas/mesh_io.h"

namespace burl {

namespace {

/// The file itself, and what it names.
std::vector<std::string> recipe_files(const std::string& path, const Recipe& recipe) {
    std::vector<std::string> files{path};
    const auto folder = std::filesystem::path(path).parent_path();
    for (const GraphImage& image : recipe.graph.images) files.push_back(folder / image.file);
    return files;
}

void read_into(FileRead& result) {
    if (result.kind == FileKind::mesh) {
        result.files = look_at(mesh_files(result.path));
        result.mesh = load_mesh(result.path);
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

FileRead read_opened(FileKind kind, const std::string& path) {
    const auto start = std::chrono::steady_clock::now();
    FileRead result{kind, path};
    try {
        read_into(result);
    } catch (const Error& problem) {
        result.problem = problem;
    } catch (const std::exception& problem) {
        result.problem = Error(ExitCode::runtime, fmt::format("{}: {}", path, problem.what()));
    }
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

EditReader::~EditReader() {
    for (const std::future<void>& one : running_) one.wait();
}

void EditReader::read(FileKind kind, const std::string& path, bool again) {
    std::erase_if(running_, [](const std::future<void>& one) {
        return one.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
    const std::scoped_lock lock(mutex_);
    const std::uint64_t number = ++numbers_;
    wanted_[std::size_t(kind)] = number;
    paths_[std::size_t(kind)] = path;
    running_.push_back(std::async(
        std::launch::async, [this, number, kind, path, again] { run(number, kind, path, again); }));
}

void EditReader::run(std::uint64_t number, FileKind kind, const std::string& path, bool again) {
    FileRead result = read_opened(kind, path);
    result.again = again;
    {
        const std::scoped_lock lock(mutex_);
        if (wanted_[std::size_t(kind)] != number) return;
        wanted_[std::size_t(kind)] = 0;
        done_.push_back(std::move(result));
    }
    changed_.notify_all();
    wake_();
}

std::string EditReader::reading(FileKind kind) const {
    const std::scoped_lock lock(mutex_);
    return wanted_[std::size_t(kind)] == 0 ? "" : paths_[std::size_t(kind)];
}

bool EditReader::idle() const {
    const std::scoped_lock lock(mutex_);
    return wanted_[0] == 0 && wanted_[1] == 0 && done_.empty();
}

void EditReader::wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return wanted_[0] == 0 && wanted_[1] == 0; });
}

std::vector<FileRead> EditReader::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(done_, {});
}

}  // namespace burl
