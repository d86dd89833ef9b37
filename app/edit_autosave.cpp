#include "app/edit_autosave.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "app/atomic_file.h"
#include "app/file_bytes.h"
#include "atlas/error.h"

namespace burl {

namespace fs = std::filesystem;

namespace {
constexpr double every_seconds = 3.0;
}

void EditAutosave::keep(const EditHistory& history, double seconds) {
    if (file_.empty()) return;
    if (!history.changed()) {
        if (written_) clear();
        return;
    }
    if (seconds - last_ < every_seconds || written_ == history.recipe()) return;
    last_ = seconds;
    written_ = history.recipe();
    try {
        fs::create_directories(fs::path(file_).parent_path());
        write_file(file_, to_json(history.recipe()));
    } catch (const Error&) {
        file_.clear();
    } catch (const fs::filesystem_error&) {
        file_.clear();
    }
}

std::optional<std::string> EditAutosave::left_behind() const {
    std::error_code unknown;
    if (file_.empty() || !fs::is_regular_file(file_, unknown)) return {};
    try {
        const auto bytes = read_file_bytes(file_);
        return std::string(bytes.begin(), bytes.end());
    } catch (const Error&) {
        return {};
    }
}

void EditAutosave::clear() {
    std::error_code unknown;
    if (!file_.empty()) fs::remove(file_, unknown);
    written_.reset();
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
