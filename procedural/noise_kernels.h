#pragma once
// The arithmetic of host synthesis on streams of texels, vectorised for the machine's instruction
// set (Highway, chosen at run time) with the same bits on every one: only additions,
// multiplications and conversions that IEEE 754 rounds, nothing fused, no sums across lanes.
//
// A texel's lattice coordinate is split in float64 into an int32 cell (wrapped) and a float32 place
// measured from the cell's middle, so its error does not grow with the distance from the origin;
// the noise itself is float32 with fades centred the same way, added up in float64.
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

/// Lattice coordinates of a batch, per axis: cell, and coordinate - (cell + 1/2) in [-1/2, 1/2].
struct LatticeBatch {
    alignas(64) std::int32_t cells[3][batch_capacity + batch_padding];
    alignas(64) float places[3][batch_capacity + batch_padding];
};

/// Splits the lines' coordinates, one line after the other. Coordinates must stay below
/// lattice_limit; the lines' counts add up to at most batch_capacity.
void split_lattice_lines(std::span<const LatticeLine> lines, LatticeBatch& batch);

/// What the kernels' sums are multiples of: they leave the noise unscaled.
constexpr double noise_unit(NoiseKind kind) {
    return kind == NoiseKind::perlin ? 0x1p-3 : 0x1p-26;
}

/// sums[j] += scale * n_seed(texel j), n the value of sample_noise, of kind `value` or `perlin`
/// only: for the same cell and place the same bits as its float32 path. The noise's own error
/// against float64, for the same cell and place, is at most 2.0e-7 (1 + |n|) for value noise and
/// 2.5e-7 (1 + |n|) for Perlin's (measured over 2.5e7 random places: 1.7e-7 and 2.4e-7; rms 3e-8).
void add_noise(NoiseKind kind, Fade fade, std::uint32_t seed, double scale,
               const LatticeBatch& batch, std::size_t count, double* sums);

/// values[j] = the parabolas, one line after the other.
void fill_parabolas(std::span<const ParabolaLine> lines, double* values);

/// Name of the instruction set the kernels run on, such as "AVX3".
std::string simd_level();

}  // namespace burl
