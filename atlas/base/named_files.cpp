#include "atlas/base/named_files.h"

#include <algorithm>
#include <filesystem>

#include "atlas/base/real_path.h"

namespace burl {

bool lies_below(const std::string& file, const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::path parent = fs::path(file).parent_path();
    const fs::path folder = fs::absolute(parent.empty() ? "." : parent, failed);
    if (failed) return false;
    const fs::path real = fs::weakly_canonical(folder, failed);
    if (failed) return false;
    const fs::path end = fs::weakly_canonical(follow_links((real / name).string()), failed);
    if (failed) return false;
    const auto [left, at] = std::mismatch(real.begin(), real.end(), end.begin(), end.end());
    return left == real.end() && at != end.end();
}

}  // namespace burl
