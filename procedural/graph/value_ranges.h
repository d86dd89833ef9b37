#pragma once
// Interval arithmetic on value programs: what the arrays of a program can hold, whatever the points
// (R. E. Moore, "Interval Analysis", 1966).
#include <span>
#include <vector>

#include "procedural/graph/value_program.h"

namespace burl {

/// low <= x <= high of every number x of an array, rounding included. Infinite where nothing is
/// known, NaN then included.
struct ValueRange {
    double low = 0.0, high = 0.0;
    bool finite() const;
};

/// Of every array of the steps, which each write arrays of their own (as before
/// ValueProgram::finish shares them), for points whose coordinates lie in `points`.
std::vector<ValueRange> value_ranges(std::span<const ValueStep> steps, std::size_t arrays,
                                     const std::array<ValueRange, 3>& points);

}  // namespace burl
