#pragma once
// The map of a disk-shaped patch onto a full rectangle: find the four corners that let a harmonic
// map stretch least, then descend on the stretch itself. The harmonic start is one to one (Tutte
// 1963, Floater 1997); the descent keeps it so, because a flip costs infinite energy. Minimised by
// L-BFGS (Nocedal, "Updating quasi-Newton matrices with limited storage", 1980) with the Laplacian
// as its first guess of the Hessian.
#include <array>
#include <optional>
#include <vector>

#include "atlas/chord_split.h"
#include "atlas/stretch.h"

namespace burl {

struct RectangleMap {
    std::array<std::size_t, 4> corners{};  ///< positions in the patch's loop: where its half-edge
                                           ///< starts; at (0,0), (1,0), (1,1), (0,1)
    std::vector<SideMask> sides;           ///< per vertex: v = 0, u = 1, v = 1, u = 0
    std::vector<Vec2d> uv;                 ///< per vertex, in the unit square
    Stretch stretch;
    std::uint32_t extra_vertices = 0;  ///< middles of chords, the patch's last vertices
};

struct DescentOptions {
    int iterations = 20;
    /// Width over height of the rectangle; without it the proportions are free.
    std::optional<double> aspect;
};

/// Maps a disk. Splits the patch's chords for the corners it chooses. Nothing, and the patch
/// unchanged, when it has fewer than four border vertices or no map without a flip is found.
std::optional<RectangleMap> map_onto_rectangle(Patch& patch, const DescentOptions& options = {});

/// The four corners with the least distortion of the harmonic map, in loop order.
std::optional<std::array<std::size_t, 4>> find_corners(const Patch& patch);

/// The harmonic map for given corners (ascending positions in the loop), border vertices spaced by
/// their length on the surface. The patch's chords must have been split. Uniform weights are tried
/// where cotangents give a flip; nothing if those do, too.
std::optional<RectangleMap> harmonic_map(const Patch& patch,
                                         const std::array<std::size_t, 4>& corners);

/// Lowers the stretch; inner vertices move freely, border vertices along their side, corners not.
/// Without an aspect the energy is D, with one it is (X/aspect + Y aspect) / (2 A^2); it never
/// rises. Returns the iterations that lowered it.
int descend(const Patch& patch, RectangleMap& map, const DescentOptions& options = {});

/// Which side(s) each vertex lies on when the corners are these.
std::vector<SideMask> side_masks(const Patch& patch, const std::array<std::size_t, 4>& corners);

}  // namespace burl
