#include "atlas/base/named_files.h"

#include <algorithm>
#include <filesystem>

namespace burl {

bool lies_below(const std::string& file, const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path parent = fs::path(file).parent_path();
    const fs::path folder = fs::weakly_canonical(parent.empty() ? "." : parent, failed);
    if (failed) return false;
    const fs::path end = fs::weakly_canonical(folder / name, failed);
    if (failed) return false;
    const auto [left, at] = std::mismatch(folder.begin(), folder.end(), end.begin(), end.end());
    return left == folder.end() && at != end.end();
}

}  // namespace burl
