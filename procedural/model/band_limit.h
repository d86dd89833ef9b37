#pragma once
// The band limit: a texel leaves out octaves that it cannot show, with a fade (pbrt's rule for its
// fractal sums: n = clamp(-1 - log2(len2) / 2, 0, max) octaves, the last faded by smoothstep(0.3,
// 0.7)).
#include <algorithm>
#include <cmath>

#include "atlas/base/vec.h"
#include "procedural/model/octaves.h"

namespace burl {

/// The weight in [0, 1] of an octave, given the square of the footprint's longer side in cells of
/// the octave's lattice: 1 while the side is up to a quarter of a cell, 0 from half a cell on and
/// for NaN.
inline double band_weight(double squared) {
    // The logarithm is left out where x is outside [0, 1] by a margin.
    if (squared < 0.09) return 1.0;
    if (!(squared < 0.17)) return 0.0;
    const double octaves_left = -1.0 - 0.5 * std::log2(squared);
    const double x = std::clamp((octaves_left - 0.3) / 0.4, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

/// The square of the length of the longer vector.
inline double longer_squared(const Vec3d& along_u, const Vec3d& along_v) {
    return std::max(glm::dot(along_u, along_u), glm::dot(along_v, along_v));
}

/// The weight of an octave, given the footprint's sides in its lattice coordinates.
inline double band_weight(const Vec3d& along_u, const Vec3d& along_v) {
    return band_weight(longer_squared(along_u, along_v));
}

/// The mean of an octave without its offset, from 12^3 points in as many cells, none of them a
/// lattice point. Signed noises have the mean 0 by their symmetry.
double octave_mean(const Octave& octave);

}  // namespace burl
