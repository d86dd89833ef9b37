// Distances are rounded down, so that rounding never hides a break.
#include "procedural/color/break_distance.h"

#include <algorithm>
#include <limits>

namespace burl {

BreakDistance::BreakDistance(const MapPieces& map) {
    const double most = map.breaks().empty() ? std::numeric_limits<float>::max() : 1.0;
    for (std::uint32_t i = 0; i <= entry_count; ++i) {
        const double low = double(i) / entry_count, high = double(i + 1) / entry_count;
        double nearest = most;
        for (const MapBreak& b : map.breaks())
            for (const double period : {-1.0, 0.0, 1.0}) {
                if (map.wrap() == Wrap::clamp && period != 0.0) continue;
                const double p = b.position + period;
                nearest = std::min(nearest, std::max({low - p, p - high, 0.0}));
            }
        distances_.push_back(float(nearest * (1.0 - 1e-6)));
    }
}

}  // namespace burl
