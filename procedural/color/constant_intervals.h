#pragma once
// Where a colour map does not change: the field values of which nobody can see what they are.
#include <vector>

#include "procedural/color/map.h"

namespace burl {

/// Indices [begin, end).
struct IndexInterval {
    double begin = 0.0, end = 0.0;
};

/// The intervals of the map's index in which PreparedColorMap gives one colour, bit for bit; with
/// `clamp` the outer ones are of field values and go on to infinity, as does the only one of a map
/// of one colour. Intervals that touch and have the same colour are one.
std::vector<IndexInterval> constant_intervals(const ColorMap& map);

}  // namespace burl
