#pragma once
// The arithmetic of host synthesis on streams of texels, vectorised for the machine's instruction
// set (Highway, chosen at run time) with the same bits on every one: only additions,
// multiplications and conversions that IEEE 754 rounds, nothing fused, no sums across lanes.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "procedural/texture.h"

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

/// Texels along a parabola: texel j has c0 + x (c1 + x c2) with x = first + j.
struct ParabolaLine {
    double c0 = 0.0, c1 = 0.0, c2 = 0.0;
    double first = 0.0;
    std::size_t count = 0;
};

/// values[j] = the parabolas, one line after the other.
void fill_parabolas(std::span<const ParabolaLine> lines, double* values);

/// Floats in a vector of the instruction set the kernels run on.
std::size_t simd_lanes();

/// Name of the instruction set the kernels run on, such as "AVX3".
std::string simd_level();

}  // namespace burl
