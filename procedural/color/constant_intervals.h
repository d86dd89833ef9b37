#pragma once
// Intervals in which a colour map is constant, so that field values within one show the same
// colour.
#include <vector>

#include "procedural/color/map.h"

namespace burl {

/// An interval [begin, end) of indices.
struct IndexInterval {
    double begin = 0.0, end = 0.0;
};

/// The intervals of the map's index in which PreparedColorMap gives one colour, bit for bit. With
/// `clamp` the outer intervals extend to infinity, as does the only interval of a map of one
/// colour. Adjacent intervals of the same colour are merged.
std::vector<IndexInterval> constant_intervals(const ColorMap& map);

}  // namespace burl
