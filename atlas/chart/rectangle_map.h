#pragma once
// The map of a disk-shaped patch onto a full rectangle: find the four corners whose harmonic map
// stretches least, then descend on the stretch itself. The harmonic start is one to one (Tutte
// 1963, Floater 1997); the descent keeps it so, because a flip costs infinite energy. The stretch
// is minimised by L-BFGS (Nocedal, "Updating quasi-Newton matrices with limited storage", 1980)
// with the Laplacian as its first guess of the Hessian.
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "atlas/chart/chord_split.h"
#include "atlas/chart/corner_search.h"
#include "atlas/chart/laplacian.h"
#include "atlas/chart/stretch.h"

namespace burl {

struct CoarseMap;  // coarse_map.h

/// A map of a patch onto the unit square.
struct RectangleMap {
    Corners corners{};
    std::vector<SideMask> sides;  ///< sides of each vertex, from bit 0: v = 0, u = 1, v = 1, u = 0
    std::vector<Vec2d> uv;        ///< place of each vertex in the unit square
    Stretch stretch;
    std::uint32_t extra_vertices = 0;         ///< number of chord middles, the last vertices
    std::shared_ptr<const CoarseMap> coarse;  ///< coarse map it was carried over from; null: none
};

/// Choices for maps onto rectangles and for the descent on their stretch.
struct DescentOptions {
    /// Largest number of iterations of the descent.
    int iterations = 20;
    /// Width over height of the rectangle; free where it is not set.
    std::optional<double> aspect{};
    /// Relative gain of the energy in an iteration below which the descent stops.
    double least_gain = 1e-7;
    /// Distortion D that is wanted: the descent is given up where it will not get there, and the
    /// search for corners where the harmonic map is too far from it.
    double wanted = std::numeric_limits<double>::infinity();
    /// Weight of StretchMeasure::anisotropy() in the energy; counts only with an aspect.
    double anisotropy = 0.0;
};

/// Maps a disk, splitting the patch's chords for the corners that it chooses. Nothing, with the
/// patch unchanged, when the patch has fewer than four border vertices, when no map without a flip
/// is found, or when the harmonic map shows that the wanted distortion is out of reach.
std::optional<RectangleMap> map_onto_rectangle(Patch& patch, const DescentOptions& options = {});

/// The harmonic map for given corners. The patch's chords must have been split. Uniform weights are
/// tried where cotangents give a flip; nothing if uniform weights give one, too.
std::optional<RectangleMap> harmonic_map(const Patch& patch, const Corners& corners);

/// Solves for inner vertices again with every triangle's weights divided by its stretch, `rounds`
/// times or until D no longer falls: two solves replace many iterations of a descent (Yoshizawa,
/// Belyaev & Seidel, "A fast and simple stretch-minimizing mesh parameterization", 2004).
void relax(const Patch& patch, const WeightedEdges& edges, RectangleMap& map, int rounds = 2);

/// Lowers the stretch; inner vertices move freely, border vertices along their side, corners not at
/// all. Without an aspect the energy is D, with one it is (X/aspect + Y aspect) / (2 A^2) and
/// the weighted anisotropy; it never rises. Returns the number of iterations that lowered it.
int descend(const Patch& patch, RectangleMap& map, const DescentOptions& options = {});
/// Lowers the stretch with the patch's weighted edges `edges`, which the overload without them
/// computes.
int descend(const Patch& patch, const WeightedEdges& edges, RectangleMap& map,
            const DescentOptions& options);

/// Sides that each vertex lies on for these corners.
std::vector<SideMask> side_masks(const Patch& patch, const Corners& corners);

}  // namespace burl
