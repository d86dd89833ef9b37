#pragma once
// Batches of texels, and the arithmetic of host synthesis on them: vectorised for the machine's
// instruction set (Highway, chosen at run time) with the same bits on every one: only additions,
// multiplications and conversions that IEEE 754 rounds, nothing fused, no sums across lanes.
#include <cstddef>

#include "atlas/base/vec.h"

namespace burl {

/// Kernels write whole vectors: every array holds `batch_padding` elements more than it has texels.
inline constexpr std::size_t batch_padding = 16;
/// Texels of a batch: its arrays (28 bytes a texel) just fit the L1 cache.
inline constexpr std::size_t batch_capacity = 1024;

/// Texels along a line of lattice coordinates: texel j has start + (first + j) * step.
struct LatticeLine {
    Vec3d start{0.0}, step{0.0};
    double first = 0.0;
    std::size_t count = 0;
};

}  // namespace burl
