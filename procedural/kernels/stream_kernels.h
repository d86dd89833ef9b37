#pragma once
// Octaves that double one another's lattice coordinates, on streams of texels: the coordinates are
// computed once, in fixed point, where doubling is a shift that loses nothing. Kernels are
// vectorised as in texel_batch.h, with the same bits on every instruction set.
#include <cstdint>
#include <span>

#include "procedural/batch/span_lines.h"
#include "procedural/batch/texel_piece.h"
#include "procedural/noise/spec.h"

namespace burl {

/// The lattice coordinates of a batch, one array per axis: cells modulo 2^32, and places in the
/// cells in units of 2^-32.
struct LatticeStream {
    alignas(64) std::uint32_t cells[3][batch_capacity + batch_padding];
    alignas(64) std::uint32_t places[3][batch_capacity + batch_padding];

    /// Cell and place of texel j as one 32.32 fixed-point number.
    std::uint64_t at(int axis, std::size_t j) const {
        return std::uint64_t(cells[axis][j]) << 32 | places[axis][j];
    }
    void set(int axis, std::size_t j, std::uint64_t coordinate) {
        cells[axis][j] = std::uint32_t(coordinate >> 32);
        places[axis][j] = std::uint32_t(coordinate);
    }
};

/// The largest number of doublings: it leaves a place enough of its 32 bits if amplitudes halve.
inline constexpr std::size_t most_doublings = 23;

/// An octave whose lattice coordinates are those of a stream times 2^doublings.
struct StreamOctave {
    std::uint32_t seed = 0;
    int doublings = 0;    ///< 0..most_doublings
    float weight = 1.0f;  ///< factor of the octave in the sum
};

/// Fills the stream with the coordinates of the pieces, one after the other. They err by 2^-32
/// cells, besides float64's rounding at the start of a line. A coordinate that reaches
/// lattice_limit after `doublings` anywhere on a line is 0 on all of it. With a period, at most
/// 2^17, cells are modulo the period instead of 2^32, and stay within 2^19 of 0. Returns the number
/// of lattice planes that the lines cross, summed over all texels.
double fill_stream(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                   LatticeStream& stream, double period = 0.0);
/// Fills the stream from span lines, with the bits that pieces of the same lines give.
double fill_stream(const Affine3& lattice_from_solid, int doublings, const SpanLines& lines,
                   LatticeStream& stream, double period = 0.0);

/// The unit of the kernels' sums: kernels add noise / unit, which saves a multiplication.
constexpr double stream_unit(NoiseKind kind) {
    return kind == NoiseKind::perlin ? 0x1p-4 : kind == NoiseKind::simplex ? 4.0 : 0x1p-34;
}

/// sums[j] += weight * n(texel j) / stream_unit(kind) in float32, where n is the value of
/// sample_noise for kind `value` or `perlin`; other kinds are not allowed. Against float64 at the
/// same place n errs by at most 1.7e-7 (1 + |n|) for value noise and 2.2e-7 (1 + |n|) for Perlin's.
void add_octave_direct(NoiseKind kind, Fade fade, const StreamOctave& octave,
                       const LatticeStream& stream, std::size_t count, float* sums);

/// sums[j] += weight * noise[j], up to the end of a vector: the sums of add_octave_direct with
/// `weight`, where `noise` holds those with weight 1, begun at 0.
void add_scaled(float weight, const float* noise, std::size_t count, float* sums);

/// values[j] += scale * sums[j].
void add_sums(double scale, const float* sums, std::size_t count, double* values);
/// values[j] = from[j] + scale * sums[j].
void add_sums_to(const double* from, double scale, const float* sums, std::size_t count,
                 double* values);

}  // namespace burl
