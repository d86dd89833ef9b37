#pragma once
// The lattice coordinates of a batch of texels: lines of pieces or of spans are mapped into a
// lattice, several to a vector, and followed in 32.32 fixed point, where the doubling of an octave
// is a shift that loses nothing. Vectorised as in texel_batch.h.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "procedural/batch/texel_batch.h"

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

/// `texels` texels of consecutive spans, beginning with texel `first` of span 0. Span i has
/// counts[i] texels on a line that begins at `start` and goes on by `step` per texel. The choice of
/// kernel depends on the whole span even where the batch has but a part of it. Kernels read (and do
/// not use) span_padding elements beyond the last span.
struct SpanLines {
    const double* start[3] = {};
    const double* step[3] = {};
    const std::uint32_t* counts = nullptr;
    std::size_t spans = 0, first = 0, texels = 0;
    const double* needed = nullptr;  ///< numbers of the texels to be prefetched, or null

    /// The line of the part of span i that the batch has; `at` is the batch's number of the part's
    /// first texel.
    LatticeLine line(std::size_t i, std::size_t at) const {
        const std::size_t before = i == 0 ? first : 0;
        const Vec3d from(start[0][i], start[1][i], start[2][i]);
        const Vec3d by(step[0][i], step[1][i], step[2][i]);
        return {from, by, double(before), std::min(counts[i] - before, texels - at)};
    }
};

/// The number of elements beyond the last span that kernels read.
inline constexpr std::size_t span_padding = 8;

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

/// The offsets of a batch's points from the texels' centres, in texels, -1 to 1.
struct TexelOffsets {
    alignas(64) float u[batch_capacity + batch_padding];
    alignas(64) float v[batch_capacity + batch_padding];
};

/// Moves a stream that fill_stream filled with the same pieces from the texels' centres to these
/// points, rounding once more to 2^-32 cells. A component of a texel's side of 2^50 cells or more
/// counts as 0.
void move_stream(const Affine3& lattice_from_solid, std::span<const Piece> pieces,
                 const TexelOffsets& offsets, LatticeStream& stream);

}  // namespace burl
