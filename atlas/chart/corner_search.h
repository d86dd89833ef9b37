#pragma once
// The search for the four border vertices of a disk that become the corners of its rectangle: those
// whose harmonic map stretches least. Candidates are judged on a copy of the patch in which every
// inner edge between two border vertices is split, so that one factor serves all candidates and
// none collapses anything.
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "atlas/chart/patch.h"

namespace burl {

/// Positions of the corners in the patch's loop, ascending: where a half-edge starts. The corners
/// go to (0,0), (1,0), (1,1), (0,1).
using Corners = std::array<std::size_t, 4>;

/// The chosen corners with the harmonic map that they give.
struct CornerChoice {
    Corners corners{};
    double distortion = std::numeric_limits<double>::infinity();  ///< D of the harmonic map
    /// The harmonic map: the places of the patch's vertices, then the places of the middles of all
    /// inner edges between two border vertices, ordered by the edges' first half-edge.
    std::vector<Vec2d> uv;
    /// An order of the patch's vertices in which eliminating them causes little fill-in
    /// (laplacian.h).
    std::vector<std::uint32_t> order;
};

/// The best corners of a patch; nothing for a patch that is no disk with four border vertices or
/// more, or has no harmonic map. The search ends early, with the best so far, when the first
/// candidates all have a distortion above `hopeless`.
std::optional<CornerChoice> search_corners(
    const Patch& patch, double hopeless = std::numeric_limits<double>::infinity());

/// Places the border on the unit square's sides, spaced by its length on the surface.
void place_border(const Patch& patch, const Corners& corners, std::span<Vec2d> uv);

/// Whether each vertex is an inner one: not in the first loop.
std::vector<bool> inner_vertices(const Patch& patch);

}  // namespace burl
