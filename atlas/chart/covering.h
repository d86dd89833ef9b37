#pragma once
// Whether a map of a patch into the plane is one to one. Where no triangle is turned over, as many
// triangles lie on a place as the borders wind round it (the degree of the map), so that the
// borders alone tell it.
#include <span>
#include <vector>

#include "atlas/chart/patch.h"
#include "atlas/mesh/unit_frame.h"

namespace burl {

/// Depth to which a map in the unit frame may cover places twice: rounding to the frame moves
/// points, and so a border over the one beside it.
inline constexpr double most_overlap = 4.0 * frame_step;

/// Whether some places of the map lie in two triangles, in a region thicker than `depth` (in units
/// of the places) or of more area than `depth` times the borders' length. No triangle may be turned
/// over. Takes time in proportion to the borders' edges times how many of them a line meets.
bool covers_twice(const Patch& patch, std::span<const Vec2d> places, double depth);

}  // namespace burl
