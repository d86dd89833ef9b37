#pragma once
// Batches of texels, and the rules of host synthesis: kernels are vectorised for the machine's
// instruction set (Highway, chosen at run time) and give the same bits on every one, because they
// use only additions, multiplications and conversions that IEEE 754 rounds, nothing fused, no sums
// across lanes.
#include <cstddef>

#include "atlas/base/vec.h"

namespace burl {

/// The elements that every array holds beyond its texels, because kernels write whole vectors.
inline constexpr std::size_t batch_padding = 16;
/// The largest number of texels in a batch, whose arrays (28 bytes a texel) then just fit the L1
/// cache.
inline constexpr std::size_t batch_capacity = 1024;

/// Texels along a line of solid or lattice coordinates: texel j lies at start + (first + j) * step.
struct LatticeLine {
    Vec3d start{0.0}, step{0.0};
    double first = 0.0;
    std::size_t count = 0;
};

}  // namespace burl
