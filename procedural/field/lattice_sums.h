#pragma once
// A texture's octaves grouped by lattice: consecutive octaves that differ in frequency, seed and
// scale alone share one lattice, whose coordinates are computed once.
#include <span>
#include <vector>

#include "procedural/kernels/noise_sum.h"
#include "procedural/model/octaves.h"

namespace burl {

/// A sum of octaves, evaluated at lattice coordinates.
struct LatticeSum {
    Affine3 lattice;  ///< map from solid to lattice coordinates
    NoiseSum sum;
};

/// The sums of `octaves`, in the octaves' order; the octaves' offsets are in none.
std::vector<LatticeSum> lattice_sums(std::span<const Octave> octaves);

}  // namespace burl
