#include "app/pipeline/refinement.h"

#include <algorithm>
#include <cmath>

namespace burl {

void LevelChoice::took(std::uint32_t level, double seconds) {
    finest_seconds_ = std::ldexp(std::max(seconds, 0.0), 2 * int(level));
}

std::uint32_t LevelChoice::level_within(double seconds) const {
    if (finest_seconds_ < 0.0) return coarsest_;
    std::uint32_t level = 0;
    while (level < coarsest_ && std::ldexp(finest_seconds_, -2 * int(level)) > seconds) ++level;
    return level;
}

std::uint32_t LevelChoice::finer_than(std::uint32_t level, double patience) const {
    return level == 0 ? 0 : std::min(level - 1, level_within(patience));
}

}  // namespace burl
