#include "app/editor/session/autosave.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "app/base/json_text.h"
#include "app/recipe/edit/images.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace fs = std::filesystem;

namespace {

/// Whether the path still leads to the open file, which its last holder may just have removed.
bool still_names(const std::string& path, int descriptor) {
    struct stat named {
    }, opened{};
    return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 &&
           named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

constexpr double every_seconds = 3.0;
constexpr std::size_t most_files = 1000;  // shared by all editors

std::string lock_of(const std::string& file) {
    return file + ".lock";
}

/// The file of what was beside a recipe.
std::string view_of(const std::string& file) {
    return fs::path(file).replace_extension(".view").string();
}

void remove_files(const std::string& file) {
    std::error_code unknown;
    fs::remove(file, unknown);
    fs::remove(view_of(file), unknown);
}

std::string text_of(const std::string& file) {
    const auto bytes = read_file_bytes(file);
    return {bytes.begin(), bytes.end()};
}

bool is_there(const std::string& file) {
    std::error_code unknown;
    return fs::is_regular_file(file, unknown);
}

std::string age_of(const std::string& file) {
    std::error_code unknown;
    const auto written = fs::last_write_time(file, unknown);
    const auto age = fs::file_time_type::clock::now() - written;
    const auto minutes = std::chrono::duration_cast<std::chrono::minutes>(age).count();
    if (unknown || minutes < 2) return "just now";
    if (minutes < 120) return fmt::format("{} minutes ago", minutes);
    const auto hours = minutes / 60;
    return hours < 48 ? fmt::format("{} hours ago", hours) : fmt::format("{} days ago", hours / 24);
}

/// Returns the name of the recipe in any text, "a recipe" where there is none.
std::string name_in(const std::string& json) {
    const Json recipe = Json::parse(json, nullptr, false);
    const bool named = recipe.is_object() && recipe.contains("name") && recipe["name"].is_string();
    return named ? recipe["name"].get<std::string>() : "a recipe";
}

std::optional<LeftRecipe> read_left(const std::string& file) {
    try {
        LeftRecipe left{file, text_of(file), "", ""};
        left.title = fmt::format("{}, {}", name_in(left.json), age_of(file));
        if (is_there(view_of(file))) left.view = text_of(view_of(file));
        return left;
    } catch (const Error&) {
        return {};
    }
}

}  // namespace

std::optional<EditLock> EditLock::take(const std::string& path) {
    constexpr int attempts = 10;
    for (int i = 0; i < attempts; ++i) {
        const int descriptor = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
        if (descriptor < 0) return {};
        const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
        if (locked && still_names(path, descriptor)) return EditLock(path, descriptor);
        ::close(descriptor);
        if (!locked) return {};
    }
    return {};
}

EditLock::EditLock(EditLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

EditLock& EditLock::operator=(EditLock&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

EditLock::~EditLock() {
    if (descriptor_ < 0) return;
    ::unlink(path_.c_str());
    ::close(descriptor_);
}

EditAutosave::EditAutosave(std::string file) : first_(std::move(file)) {
    find_left();
}

std::string EditAutosave::file_of(std::size_t number) const {
    if (number == 0) return first_;
    const fs::path path = first_;
    return (path.parent_path() /
            fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string()))
        .string();
}

void EditAutosave::find_left() {
    for (std::size_t i = 0; i < most_files && !first_.empty(); ++i) {
        const std::string file = file_of(i);
        if (!is_there(file)) continue;
        std::optional<EditLock> lock = EditLock::take(lock_of(file));
        if (!lock || !is_there(file)) continue;  // its editor is running, or has just ended
        std::optional<LeftRecipe> left = read_left(file);
        if (!left) continue;
        left_.push_back(std::move(*left));
        left_locks_.push_back(std::move(*lock));
    }
}

/// Claims the first unused file for a document; a file left by another editor is in use.
EditAutosave::Kept& EditAutosave::claim(std::uint64_t document) {
    for (std::size_t i = 0; i < most_files; ++i) {
        std::string file = file_of(i);
        if (is_there(file)) continue;
        std::optional<EditLock> lock = EditLock::take(lock_of(file));
        if (!lock || is_there(file)) continue;
        return kept_.emplace_back(Kept{document, std::move(file), std::move(*lock), {}});
    }
    throw Error(ExitCode::io, "no autosave is to be had");
}

EditAutosave::Kept& EditAutosave::kept(std::uint64_t document) {
    const auto found = std::ranges::find(kept_, document, &Kept::document);
    return found == kept_.end() ? claim(document) : *found;
}

void EditAutosave::write(const EditHistory::Unsaved& unsaved) {
    Kept& place = kept(unsaved.document);
    write_view(place);
    if (place.written == *unsaved.recipe) return;
    write_file(place.file, to_json(with_absolute_images(*unsaved.recipe, unsaved.path)));
    place.written = *unsaved.recipe;
}

void EditAutosave::write_view(Kept& place) const {
    if (place.view == view_) return;
    write_file(view_of(place.file), view_);
    place.view = view_;
}

void EditAutosave::write_all(const AllUnsaved& all) {
    try {
        fs::create_directories(fs::path(first_).parent_path());
        for (const EditHistory::Unsaved& unsaved : all) write(unsaved);
    } catch (const Error&) {
        first_.clear();
    } catch (const fs::filesystem_error&) {
        first_.clear();
    }
}

/// Removes the files of documents that have no unsaved changes any more.
void EditAutosave::remove_others(const AllUnsaved& all) {
    std::erase_if(kept_, [&](const Kept& one) {
        const auto is_this = [&](const auto& unsaved) { return unsaved.document == one.document; };
        if (std::ranges::any_of(all, is_this)) return false;
        remove_files(one.file);
        return true;
    });
}

void EditAutosave::keep(const EditHistory& history, double seconds, const std::string& view) {
    if (first_.empty()) return;
    view_ = view;
    const AllUnsaved all = history.all_unsaved();
    remove_others(all);
    if (all.empty() || seconds - last_ < every_seconds) return;
    last_ = seconds;
    write_all(all);
}

void EditAutosave::take(std::size_t left, const EditHistory& history) {
    if (!first_.empty()) write_all(history.all_unsaved());
    if (first_.empty())
        forget(left);  // without autosave, the left file is the only copy of the recipe
    else
        throw_away(left);
}

void EditAutosave::throw_away(std::size_t left) {
    remove_files(left_[left].file);
    forget(left);
}

void EditAutosave::forget(std::size_t left) {
    left_.erase(left_.begin() + std::ptrdiff_t(left));
    left_locks_.erase(left_locks_.begin() + std::ptrdiff_t(left));
}

void EditAutosave::leave_all() {
    left_.clear();
    left_locks_.clear();
}

void EditAutosave::clear() {
    remove_others({});
}

std::string state_file(const std::string& name) {
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && fs::path(state).is_absolute())
        return (fs::path(state) / "burl" / name).string();
    const char* home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') return {};
    return (fs::path(home) / ".local" / "state" / "burl" / name).string();
}

}  // namespace burl
