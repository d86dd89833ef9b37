#pragma once
// Octaves that double one another's lattice coordinates, on streams of texels (lattice_stream.h).
// Kernels are vectorised as in texel_batch.h, with the same bits on every instruction set.
#include "procedural/kernels/lattice_stream.h"
#include "procedural/noise/spec.h"

namespace burl {

/// The largest number of doublings: it leaves a place enough of its 32 bits if amplitudes halve.
inline constexpr std::size_t most_doublings = 23;

/// An octave whose lattice coordinates are those of a stream times 2^doublings.
struct StreamOctave {
    std::uint32_t seed = 0;
    int doublings = 0;     ///< 0..most_doublings
    float weight = 1.0f;   ///< factor of the octave in the sum
    double radius2 = 0.0;  ///< squared radius of simplex noise's kernel
};

/// The unit of the kernels' sums: kernels add noise / unit, which saves a multiplication.
constexpr double stream_unit(NoiseKind kind) {
    return kind == NoiseKind::perlin ? 0x1p-4 : kind == NoiseKind::simplex ? 4.0 : 0x1p-34;
}

struct CellRuns;      // share_kernels.h
struct GradientSums;  // slope_kernels.h

/// The kernel of one kind of noise on the machine's instruction set. It adds an octave at `count`
/// texels: sums[j] += weight * n(texel j) / stream_unit in float32. Kernels of slopes also add the
/// noise's derivatives to `gradients`, and kernels that share corners read `runs`, those of at
/// least octave.doublings; other kernels take null for them.
using OctaveKernel = void (*)(const StreamOctave& octave, const LatticeStream& stream,
                              const CellRuns* runs, std::size_t count, float* sums,
                              GradientSums* gradients);

/// The kernel by which every texel hashes the corners of its own cell; n is the value of
/// sample_noise for kind `value` or `perlin`; other kinds are not allowed. Against float64 at the
/// same place n errs by at most 1.7e-7 (1 + |n|) for value noise and 2.2e-7 (1 + |n|) for Perlin's.
OctaveKernel direct_kernel(NoiseKind kind, Fade fade);

/// sums[j] += weight * noise[j], up to the end of a vector: the sums of direct_kernel with
/// `weight`, where `noise` holds those with weight 1, begun at 0.
void add_scaled(float weight, const float* noise, std::size_t count, float* sums);

/// values[j] += scale * sums[j].
void add_sums(double scale, const float* sums, std::size_t count, double* values);
/// values[j] = from[j] + scale * sums[j].
void add_sums_to(const double* from, double scale, const float* sums, std::size_t count,
                 double* values);

/// An octave's cached noise, and its weight in the sum.
struct KeptSummand {
    float weight = 0.0f;
    const float* noise = nullptr;
};

/// values[j] += scale * (0 + weight * noise[j] + ...), the bracket in float32 in the summands'
/// order; the bits are those of add_scaled for every summand and add_sums. One pass adds all
/// octaves, since the numbers come from main memory.
void add_kept_sums(std::span<const KeptSummand> summands, double scale, std::size_t count,
                   double* values);

}  // namespace burl
