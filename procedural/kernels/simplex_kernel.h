#pragma once
// Simplex noise in three dimensions (Perlin 2001, appendix B) on streams of texels, vectorised as
// in texel_batch.h, with the same bits on every instruction set. Whole numbers from the stream's
// fixed-point coordinates choose the simplex, so rounding never picks another one.
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// The number of cells after which simplex noise repeats along every axis: 256 for the hash times 3
/// for the skew. Streams for it must be filled with this period.
inline constexpr int simplex_period = 768;
/// The number of doublings after which the sum of a texel's three cells, which a period keeps below
/// 2^19, still fits 32 bits.
inline constexpr std::size_t most_simplex_doublings = 9;

/// The kernel of simplex noise n of squared radius octave.radius2. At texels that are multiples of
/// 2^-29 cells n errs by at most 3e-7 against float64, by 1.2e-7 for radius2 0.5 (measured over
/// 2.5e7 random texels: 2.2e-7 and 9.0e-8, rms 2.7e-8); other texels are moved down to such a
/// multiple. With `gradients`, which changes no bit of the sums, it adds weight * dn /
/// stream_unit(simplex) with respect to the stream's coordinates to the gradients; a component of
/// dn errs by at most 2e-6 in the octave's own coordinates.
OctaveKernel simplex_kernel(bool gradients);

}  // namespace burl
