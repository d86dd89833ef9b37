#include "atlas/base/real_path.h"

#include <filesystem>

namespace burl {

std::string follow_links(const std::string& path) {
    std::filesystem::path end = path;
    std::error_code ignored;
    for (int depth = 0; depth < 40 && std::filesystem::is_symlink(end, ignored); ++depth) {
        const std::filesystem::path next = std::filesystem::read_symlink(end, ignored);
        if (ignored) break;
        end = next.is_absolute() ? next : end.parent_path() / next;
    }
    return end.string();
}

std::string real_path(const std::string& path) {
    // Links come first, since weakly_canonical takes a link to a missing file for missing itself;
    // absolute() comes next, since weakly_canonical leaves a relative path unresolved whose first
    // part is missing.
    std::error_code failed;
    const std::filesystem::path absolute = std::filesystem::absolute(follow_links(path), failed);
    if (failed) return path;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(absolute, failed);
    return failed || whole.empty() ? path : whole.string();
}

}  // namespace burl
