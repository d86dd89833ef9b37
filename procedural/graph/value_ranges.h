#pragma once
// Interval arithmetic on value programs: the ranges of the arrays of a program for points in a
// given box (R. E. Moore, "Interval Analysis", 1966).
#include <span>
#include <vector>

#include "procedural/graph/value_program.h"

namespace burl {

/// The range of the numbers x of an array, low <= x <= high, rounding included. Infinite where
/// nothing is known; x may then be NaN, too.
struct ValueRange {
    double low = 0.0, high = 0.0;
    bool finite() const;
};

/// The range of every array of the steps, which must each write arrays of their own (as before
/// ValueProgram::finish shares them), for points whose coordinates lie in `points`.
std::vector<ValueRange> value_ranges(std::span<const ValueStep> steps, std::size_t arrays,
                                     const std::array<ValueRange, 3>& points);

}  // namespace burl
