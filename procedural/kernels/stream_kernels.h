#pragma once
// Octaves that double one another's lattice coordinates, on streams of texels: the coordinates are
// worked out once, in fixed point, where doubling is a shift that loses nothing. Vectorised as in
// texel_batch.h and with the same bits on every instruction set.
#include <cstdint>
#include <span>

#include "procedural/batch/span_lines.h"
#include "procedural/batch/texel_piece.h"
#include "procedural/noise/spec.h"

namespace burl {

/// Lattice coordinates of a batch per axis: cells modulo 2^32, and places in them in units of 2^-32
/// cells.
struct LatticeStream {
    alignas(64) std::uint32_t cells[3][batch_capacity + batch_padding];
    alignas(64) std::uint32_t places[3][batch_capacity + batch_padding];

    /// Both as one number.
    std::uint64_t at(int axis, std::size_t j) const {
        return std::uint64_t(cells[axis][j]) << 32 | places[axis][j];
    }
    void set(int axis, std::size_t j, std::uint64_t coordinate) {
        cells[axis][j] = std::uint32_t(coordinate >> 32);
        places[axis][j] = std::uint32_t(coordinate);
    }
};

/// Doublings that leave a place enough of its 32 bits, given amplitudes that halve.
inline constexpr std::size_t most_doublings = 23;

/// An octave whose lattice coordinates are those of a stream times 2^doublings.
struct StreamOctave {
    std::uint32_t seed = 0;
    int doublings = 0;    ///< 0..most_doublings
    float weight = 1.0f;  ///< of the octave in the sum
};

/// Coordinates of the pieces, one after the other. They err by 2^-32 cells, besides what float64
/// loses at the start of a line. Lines that reach lattice_limit after `doublings` on an axis stay
/// at 0 on it. Returns how many planes of the lattice the lines cross, all texels together.
/// With a period, at most 2^17, cells are modulo it instead of 2^32, and stay within 2^19 of 0.
double fill_stream(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                   LatticeStream& stream, double period = 0.0);
/// The same bits of the same lines.
double fill_stream(const Affine3& lattice_from_solid, int doublings, const SpanLines& lines,
                   LatticeStream& stream, double period = 0.0);

/// What the kernels' sums are multiples of: they leave the noise unscaled.
constexpr double stream_unit(NoiseKind kind) {
    return kind == NoiseKind::perlin ? 0x1p-4 : kind == NoiseKind::simplex ? 4.0 : 0x1p-34;
}

/// sums[j] += weight * n(texel j) / stream_unit(kind) in float32, n the value of sample_noise, of
/// kind `value` or `perlin` only. n errs by at most 1.7e-7 (1 + |n|) for value noise and 2.2e-7 (1
/// + |n|) for Perlin's against float64 at the same place.
void add_octave_direct(NoiseKind kind, Fade fade, const StreamOctave& octave,
                       const LatticeStream& stream, std::size_t count, float* sums);

/// sums[j] += weight * noise[j], up to the end of a vector: what add_octave_direct adds whose own
/// weight is 1.
void add_scaled(float weight, const float* noise, std::size_t count, float* sums);

/// values[j] += scale * sums[j].
void add_sums(double scale, const float* sums, std::size_t count, double* values);
/// values[j] = from[j] + scale * sums[j].
void add_sums_to(const double* from, double scale, const float* sums, std::size_t count,
                 double* values);

}  // namespace burl
