#pragma once
// Edits of a colour map's stops that leave a valid map: positions stay in order, at least one stop
// is left.
#include <cstddef>
#include <vector>

#include "procedural/color/map.h"

namespace burl {

/// Moves a stop as near to `position` as its neighbours let it.
std::vector<ColorStop> with_stop_moved(std::vector<ColorStop> stops, std::size_t index,
                                       double position);

/// Adds a stop of the colour that the map has there; `at` becomes its index. The map's colours
/// change by no more than that colour's rounding to 8 bits.
std::vector<ColorStop> with_stop_added(const ColorMap& map, double position, std::size_t& at);

/// The last stop stays.
std::vector<ColorStop> with_stop_removed(std::vector<ColorStop> stops, std::size_t index);

/// The map's colours at `count` equally spaced indices from 0 to 1, as they are shown.
std::vector<Rgb8> map_colors(const ColorMap& map, std::size_t count);

}  // namespace burl
