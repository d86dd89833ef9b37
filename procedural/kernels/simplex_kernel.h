#pragma once
// Simplex noise in three dimensions (Perlin 2001, appendix B) on streams of texels, vectorised as
// in texel_batch.h and with the same bits on every instruction set. The simplex is chosen by
// whole numbers from the stream's fixed-point coordinates, so rounding never picks another one.
#include "procedural/kernels/slope_kernels.h"

namespace burl {

/// Cells after which simplex noise repeats along every axis: hash and skew, 256 times 3. Streams
/// for it must be filled with this period.
inline constexpr int simplex_period = 768;
/// Doublings after which the sum of a texel's three cells, which a period keeps below 2^19, still
/// fits 32 bits.
inline constexpr std::size_t most_simplex_doublings = 9;

/// As add_octave_direct with simplex noise of squared radius `radius2`: sums[j] += weight * n /
/// stream_unit(simplex). At texels that are multiples of 2^-29 cells n errs by at most 3e-7 against
/// float64, 1.2e-7 for radius2 0.5 (measured over 2.5e7 random ones: 2.2e-7 and 9.0e-8,
/// rms 2.7e-8); others are cut to one.
void add_simplex_octave(const StreamOctave& octave, double radius2, const LatticeStream& stream,
                        std::size_t count, float* sums);

/// The same, to the bit, and adds weight * dn / stream_unit(simplex) with respect to the stream's
/// coordinates to the gradients. A component of dn errs by at most 2e-6 in the octave's own
/// coordinates.
void add_simplex_octave_and_gradient(const StreamOctave& octave, double radius2,
                                     const LatticeStream& stream, std::size_t count, float* sums,
                                     GradientSums& gradients);

}  // namespace burl
