#pragma once
// A texture's octaves as sums in lattices of their own: octaves that differ by frequency and seed
// alone share one, so that its coordinates are worked out once.
#include <span>
#include <vector>

#include "procedural/kernels/noise_sum.h"
#include "procedural/model/octaves.h"

namespace burl {

/// The sum at the lattice coordinates.
struct LatticeSum {
    Affine3 lattice;  ///< from the solid
    NoiseSum sum;
};

/// In the octaves' order, their offsets left out.
std::vector<LatticeSum> lattice_sums(std::span<const Octave> octaves);

}  // namespace burl
