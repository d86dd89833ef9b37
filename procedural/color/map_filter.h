#pragma once
// The colour map averaged over a footprint, exactly: over a texel f is nearly linear, so its values
// are distributed as a box (one axis) or a trapezoid (two), and the map is piecewise linear, so the
// mean is a closed form. After Hart et al. 1999, section 3, whose tables approximate the box.
#include "procedural/color/map_pieces.h"

namespace burl {

/// The changes of f across a footprint along its two axes, |df/du| and |df/dv| times the
/// footprint's sides; `wide` >= `narrow` >= 0.
struct FilterWidths {
    double wide = 0.0, narrow = 0.0;

    /// The widths of two changes of f, in either order and with any sign.
    static FilterWidths of(double along_u, double along_v);
    /// The side of the box of the same variance: sqrt(wide^2 + narrow^2).
    double box() const;
};

/// The mean of c over [f - width/2, f + width/2], in linear light, width >= 0; f or a width that is
/// not finite counts as f = 0, width = 0. The error is at most 2e-7.
Vec3d box_filtered(const MapPieces& map, double f, double width);

/// The mean of c(f + wide U + narrow V), U and V uniform in [-1/2, 1/2], in linear light. The error
/// against the integral is at most 2e-7, at f = 1e9 as at 0 (measured by the test).
Vec3d trapezoid_filtered(const MapPieces& map, double f, const FilterWidths& widths);

}  // namespace burl
