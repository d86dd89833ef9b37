#pragma once
// Which four border vertices of a disk become the corners of its rectangle: those whose harmonic
// map stretches least. Candidates are judged on a copy of the patch in which every inner edge
// between two border vertices is split, so that one factor serves all and none collapses anything.
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "atlas/patch/patch.h"

namespace burl {

/// Positions in the patch's loop, ascending: where its half-edge starts. They go to (0,0), (1,0),
/// (1,1), (0,1).
using Corners = std::array<std::size_t, 4>;

struct CornerChoice {
    Corners corners{};
    double distortion = std::numeric_limits<double>::infinity();  ///< D of the harmonic map
    /// The harmonic map: per vertex of the patch, then per inner edge between two border vertices
    /// the place of its middle, by the edges' first half-edge.
    std::vector<Vec2d> uv;
    /// In which eliminating the patch's vertices fills little (laplacian.h).
    std::vector<std::uint32_t> order;
};

/// Nothing for a patch that is no disk with four border vertices or more, or has no harmonic map.
/// The search ends early, with the best so far, when all of the first candidates have a distortion
/// above `hopeless`.
std::optional<CornerChoice> search_corners(
    const Patch& patch, double hopeless = std::numeric_limits<double>::infinity());

/// Places the border on the unit square's sides, spaced by its length on the surface.
void place_border(const Patch& patch, const Corners& corners, std::span<Vec2d> uv);

/// True for the vertices that are not in the first loop.
std::vector<bool> inner_vertices(const Patch& patch);

}  // namespace burl
