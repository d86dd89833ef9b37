#include "app/base/simd_limit.h"

#include <algorithm>

#include <fmt/format.h>

#include "atlas/base/error.h"
#include "procedural/numbers/simd_target.h"

namespace burl {

void limit_simd(const std::string& level) {
    const std::vector<std::string> names = simd_targets();
    if (std::ranges::find(names, level) == names.end())
        throw Error(ExitCode::usage, fmt::format("--simd {}: must be one of this machine's, {}",
                                                 level, fmt::join(names, ", ")));
    use_simd_target(level);
}

}  // namespace burl
