#pragma once
// Percentiles of a surface rather than of a list: every value stands for some area, so that a
// thousand specks do not outvote one large face.
#include <span>

namespace burl {

/// A value that holds on `area` of a surface; ordered by value.
struct WeightedValue {
    double value = 0.0, area = 0.0;
    bool operator<(const WeightedValue& other) const { return value < other.value; }
};

/// Smallest value v such that at least `share` (0..1) of `area`, the sum of all areas, has values
/// of at most v. `sorted` is in ascending order; the result is 0 where it is empty.
inline double weighted_percentile(std::span<const WeightedValue> sorted, double area,
                                  double share) {
    double below = 0.0;
    for (const WeightedValue& each : sorted) {
        below += each.area;
        if (below >= share * area) return each.value;
    }
    return sorted.empty() ? 0.0 : sorted.back().value;
}

}  // namespace burl
