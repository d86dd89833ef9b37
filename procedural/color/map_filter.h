#pragma once
// The colour map averaged over a footprint, exactly: over a texel f is nearly linear, so its values
// are spread like a box (one axis) or a trapezoid (two), and the map is piecewise linear, so the
// mean is a closed form. After Hart et al. 1999, section 3, whose tables approximate the box.
#include "procedural/color/map_pieces.h"

namespace burl {

/// By how much f changes across a footprint along each of its two axes, |df/du| and |df/dv| times
/// the footprint's sides; `wide` >= `narrow` >= 0.
struct FilterWidths {
    double wide = 0.0, narrow = 0.0;

    /// Of the partial derivatives, in either order and with any sign.
    static FilterWidths of(double along_u, double along_v);
    /// Side of the box of the same variance: sqrt(wide^2 + narrow^2).
    double box() const;
};

/// Mean of c over [f - width/2, f + width/2], linear light, for any finite f and width >= 0. What
/// is not finite counts as f = 0, width = 0. Error: as below.
Vec3d box_filtered(const MapPieces& map, double f, double width);

/// Mean of c(f + wide U + narrow V), U and V even in [-1/2, 1/2], linear light. Error at most 2e-7
/// against the integral, at f = 1e9 as at 0 (measured: see the test).
Vec3d trapezoid_filtered(const MapPieces& map, double f, const FilterWidths& widths);

}  // namespace burl
