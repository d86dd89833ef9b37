#pragma once
// Finds which points of a file are one point of the surface: those with equal bits, or those nearer
// to each other than a distance. Everything downstream (connectivity, seams, charts) rests on it.
#include <cstdint>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

/// Points after welding, and the corners that use them.
struct WeldedPoints {
    std::vector<Vec3d> positions;        ///< distinct points, numbered by first use in `corners`
    std::vector<std::uint32_t> corners;  ///< given corners, renumbered to `positions`
    std::uint64_t unreferenced = 0;      ///< points that no corner uses
    std::uint64_t merged = 0;            ///< used points that coincide with an earlier one
};

/// Welds `points` in the order `corners` uses them; each point goes to the earliest welded one with
/// the same bits (-0 counts as 0), or, for distance > 0, to the earliest welded one within
/// `distance`. The result does not depend on how often a file repeats a vertex.
WeldedPoints weld_points(const std::vector<Vec3d>& points, std::vector<std::uint32_t> corners,
                         double distance);

}  // namespace burl
