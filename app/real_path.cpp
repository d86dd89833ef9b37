#include "app/real_path.h"

#include <filesystem>

namespace burl {

std::string real_path(const std::string& path) {
    // Made absolute first: of a relative path whose first part is missing, weakly_canonical leaves
    // the rest as it is.
    std::error_code failed;
    const std::filesystem::path absolute = std::filesystem::absolute(path, failed);
    if (failed) return path;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(absolute, failed);
    return failed || whole.empty() ? path : whole.string();
}

}  // namespace burl
