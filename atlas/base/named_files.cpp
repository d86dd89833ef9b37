#include "atlas/base/named_files.h"

#include <algorithm>
#include <filesystem>

#include "atlas/base/real_path.h"

namespace burl {

bool lies_below(const std::string& file, const std::string& name) {
    namespace fs = std::filesystem;
    const fs::path parent = fs::path(file).parent_path();
    const fs::path folder = real_path(parent.empty() ? "." : parent.string());
    const fs::path end = real_path((folder / name).string());
    const auto [left, at] = std::mismatch(folder.begin(), folder.end(), end.begin(), end.end());
    return left == folder.end() && at != end.end();
}

}  // namespace burl
