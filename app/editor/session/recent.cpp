#include "app/editor/session/recent.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "atlas/base/error.h"
#include "atlas/base/real_path.h"

namespace burl {

namespace fs = std::filesystem;

RecentFiles::RecentFiles(std::string file) : file_(std::move(file)) {
    read();
}

void RecentFiles::read() {
    std::error_code unknown;
    if (file_.empty() || !fs::is_regular_file(file_, unknown)) return;
    try {
        const auto bytes = read_file_bytes(file_);
        std::istringstream lines(std::string(bytes.begin(), bytes.end()));
        paths_.clear();
        for (std::string line; paths_.size() < most_recent_files && std::getline(lines, line);)
            if (!line.empty()) paths_.push_back(line);
    } catch (const Error&) {  // the list is unreadable or was just removed
    }
}

void RecentFiles::add(const std::string& path) {
    std::error_code unknown;
    const std::string name = real_path(path);
    if (!fs::is_regular_file(name, unknown) || name.find('\n') != std::string::npos) return;
    read();
    std::erase(paths_, name);
    paths_.insert(paths_.begin(), name);
    if (paths_.size() > most_recent_files) paths_.resize(most_recent_files);
    if (file_.empty()) return;
    try {
        fs::create_directories(fs::path(file_).parent_path());
        write_file(file_, fmt::format("{}\n", fmt::join(paths_, "\n")));
    } catch (const std::exception&) {
        file_.clear();
    }
}

}  // namespace burl
