#pragma once
// Edits of a colour map's stops that keep the map valid: positions ascend from 0 to 1, and at least
// one stop remains.
#include <cstddef>
#include <vector>

#include "procedural/color/map.h"

namespace burl {

/// Moves a stop to `position`, past others where those are in the way; `at` is its index before and
/// after.
std::vector<ColorStop> with_stop_moved(std::vector<ColorStop> stops, std::size_t& at,
                                       double position);

/// Moves a stop to `position`, clamped between its neighbours, so that all keep their indices.
std::vector<ColorStop> with_stop_moved_between(std::vector<ColorStop> stops, std::size_t index,
                                               double position);

/// Adds a stop at `position` with the map's colour there; `at` returns its index. The map's colours
/// change by no more than the rounding of that colour to 8 bits.
std::vector<ColorStop> with_stop_added(const ColorMap& map, double position, std::size_t& at);

/// Removes a stop unless it is the only one.
std::vector<ColorStop> with_stop_removed(std::vector<ColorStop> stops, std::size_t index);

/// The map's colours at `count` equally spaced indices from 0 to 1, in sRGB codes, over the colour
/// `behind` where they are transparent.
std::vector<Rgb8> map_colors(const ColorMap& map, std::size_t count, const Rgb8& behind = {});

}  // namespace burl
