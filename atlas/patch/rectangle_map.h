#pragma once
// The map of a disk-shaped patch onto a full rectangle: find the four corners that let a harmonic
// map stretch least, then descend on the stretch itself. The harmonic start is one to one (Tutte
// 1963, Floater 1997); the descent keeps it so, because a flip costs infinite energy. Minimised by
// L-BFGS (Nocedal, "Updating quasi-Newton matrices with limited storage", 1980) with the Laplacian
// as its first guess of the Hessian.
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "atlas/patch/chord_split.h"
#include "atlas/patch/corner_search.h"
#include "atlas/patch/laplacian.h"
#include "atlas/patch/stretch.h"

namespace burl {

struct CoarseMap;  // coarse_map.h

struct RectangleMap {
    Corners corners{};
    std::vector<SideMask> sides;  ///< per vertex: v = 0, u = 1, v = 1, u = 0
    std::vector<Vec2d> uv;        ///< per vertex, in the unit square
    Stretch stretch;
    std::uint32_t extra_vertices = 0;         ///< middles of chords, the patch's last vertices
    std::shared_ptr<const CoarseMap> coarse;  ///< that it was carried over from, for a large patch
};

struct DescentOptions {
    int iterations = 20;
    /// Width over height of the rectangle; without it the proportions are free.
    std::optional<double> aspect{};
    /// The descent stops where it gains less than this share of the energy in an iteration.
    double least_gain = 1e-7;
    /// What is wanted of D: the descent is given up where it will not get there, and a search for
    /// corners where the harmonic map is too far from it.
    double wanted = std::numeric_limits<double>::infinity();
};

/// Maps a disk. Splits the patch's chords for the corners it chooses. Nothing, and the patch
/// unchanged, when it has fewer than four border vertices, no map without a flip is found, or it is
/// plain from the harmonic map that the wanted distortion is out of reach.
std::optional<RectangleMap> map_onto_rectangle(Patch& patch, const DescentOptions& options = {});

/// The harmonic map for given corners. The patch's chords must have been split. Uniform weights are
/// tried where cotangents give a flip; nothing if those do, too.
std::optional<RectangleMap> harmonic_map(const Patch& patch, const Corners& corners);

/// Solves for inner vertices again with every triangle's weights divided by its stretch, `rounds`
/// times or until D no longer falls: few steps on the way that takes a descent many (Yoshizawa,
/// Belyaev & Seidel, "A fast and simple stretch-minimizing mesh parameterization", 2004).
void relax(const Patch& patch, const WeightedEdges& edges, RectangleMap& map, int rounds = 2);

/// Lowers the stretch; inner vertices move freely, border vertices along their side, corners not.
/// Without an aspect the energy is D, with one it is (X/aspect + Y aspect) / (2 A^2); it never
/// rises. Returns the iterations that lowered it.
int descend(const Patch& patch, RectangleMap& map, const DescentOptions& options = {});
int descend(const Patch& patch, const WeightedEdges& edges, RectangleMap& map,
            const DescentOptions& options);

/// Which side(s) each vertex lies on when the corners are these.
std::vector<SideMask> side_masks(const Patch& patch, const Corners& corners);

}  // namespace burl
