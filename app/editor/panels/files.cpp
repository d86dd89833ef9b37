#include "app/editor/panels/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "atlas/base/error.h"
#include "atlas/file/file_extension.h"

namespace burl {

namespace fs = std::filesystem;

namespace {

bool fits(const std::string& name, const std::vector<std::string>& extensions) {
    const std::string extension = lower_extension(name);
    return extensions.empty() || std::ranges::find(extensions, extension) != extensions.end();
}

}  // namespace

std::vector<FolderEntry> list_folder(const std::string& folder,
                                     const std::vector<std::string>& extensions) {
    std::vector<FolderEntry> entries;
    std::error_code problem;
    for (fs::directory_iterator it(folder, problem), end; !problem && it != end;
         it.increment(problem)) {
        const std::string name = it->path().filename().string();
        std::error_code unknown;
        const bool is_folder = it->is_directory(unknown);
        if (name.starts_with('.') || !(is_folder || fits(name, extensions))) continue;
        entries.push_back({name, is_folder});
    }
    std::ranges::sort(entries, [](const FolderEntry& a, const FolderEntry& b) {
        return a.folder != b.folder ? a.folder : a.name < b.name;
    });
    return entries;
}

std::string file_name(const std::string& path) {
    return fs::path(path).filename().string();
}

std::string claim_numbered(const std::string& stem, const std::string& extension) {
    for (int number = 1;; ++number) {
        std::string path = fmt::format("{}-{:03}{}", stem, number, extension);
        const int descriptor = ::open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            ::close(descriptor);
            return path;
        }
        if (errno != EEXIST)
            throw Error(ExitCode::io, fmt::format("{}: cannot be written: {}", path,
                                                  std::generic_category().message(errno)));
    }
}

std::string expanded_home(const std::string& path) {
    const char* home = std::getenv("HOME");
    const bool leads = path == "~" || path.starts_with("~/");
    return leads && home != nullptr && *home != '\0' ? home + path.substr(1) : path;
}

}  // namespace burl
