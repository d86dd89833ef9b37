#include "procedural/color/constant_intervals.h"

#include <algorithm>
#include <limits>

#include "procedural/color/table.h"

namespace burl {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<IndexInterval> constant_intervals(const ColorMap& colors) {
    const PreparedColorMap map(colors);
    const bool clamps = map.wrap() == Wrap::clamp;
    const double after = clamps ? 2.0 : 1.0;  // index 1 is a point of its own with `clamp`
    std::vector<IndexInterval> intervals;
    std::vector<Vec3d> of;
    for (std::size_t i = 0; i + 1 < map.segments(); ++i) {
        const IndexInterval interval{std::max(map.begin(i), 0.0),
                                     std::min(map.begin(i + 1), after)};
        if (interval.begin >= interval.end || map.slope(i) != Vec3d(0.0)) continue;
        const Vec3d color = map.color(i, interval.begin);
        if (!intervals.empty() && intervals.back().end == interval.begin && of.back() == color) {
            intervals.back().end = interval.end;
            continue;
        }
        intervals.push_back(interval);
        of.push_back(color);
    }
    if (intervals.empty()) return intervals;
    const bool all = intervals.front().begin == 0.0 && intervals.front().end >= after;
    if (intervals.front().begin == 0.0 && (clamps || all)) intervals.front().begin = -infinity;
    if (intervals.back().end >= after && (clamps || all)) intervals.back().end = infinity;
    return intervals;
}

}  // namespace burl
