#pragma once
// Octaves along scan lines by their closed form between two lattice planes ("Bresenham Noise",
// Kameya & Hart, eq. 12 and 15): value noise with the linear fade is a cubic polynomial of the
// texel's index; value noise with other fades blends eight corner values, Perlin's noise eight
// linear functions, by fades of coordinates that are linear in the index. The crossings of a line
// with lattice planes are computed, not searched for, and lattice coordinates are evaluated once
// per cell instead of once per texel. On long lines this is faster than sharing corners; the
// results round differently, so that the choice may depend on the line alone.
#include <span>
#include <vector>

#include "procedural/kernels/stream_kernels.h"

namespace burl {

/// The largest length of a line in texels: float32 holds every texel's index up to it to the half.
inline constexpr double longest_scan_line = 0x1p22;

/// A piece in the lattice coordinates of a group's first octave. Segments depend on the whole span,
/// so that the bits do not depend on where pieces begin and end.
struct ScanLine {
    LatticeLine line;
    /// Length of the whole span in texels.
    double length = 0.0;
    Vec3d texels_per_cell{0.0};  ///< texels per cell on each axis; infinite if the step is 0
};

/// Replaces `lines` with the lines of `pieces`. A coordinate that reaches lattice_limit after
/// `doublings` anywhere on the span is 0 on all of the line, as in fill_stream.
void map_scan_lines(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                    std::vector<ScanLine>& lines);

/// Segments of a batch: maximal runs of texels of one line that lie in one lattice cell, with the
/// coefficients of their noise. Scratch arrays of add_octave_scanline, one per thread.
struct ScanSegments {
    static constexpr std::size_t capacity = batch_capacity + batch_padding;
    /// The largest number of coefficients per segment, those of Perlin's noise.
    static constexpr std::size_t most_numbers = 22;
    std::size_t count = 0;
    /// The number of 64-bit words in `borders`.
    static constexpr std::size_t words = batch_capacity / 64 + 1;
    /// Bit set with one bit per texel, set for the first texel of every segment.
    std::uint64_t borders[words];
    /// Index, relative to the batch, of the middle of the whole segment, of which the batch may
    /// hold a part.
    alignas(64) float middle[capacity];
    /// Cells of the segments' middles on each axis, modulo 2^32.
    alignas(64) std::uint32_t cells[3][capacity];
    /// Positions of the segments' middles relative to the centre of their cell, in [-1/2, 1/2]
    /// cells.
    alignas(64) float places[3][capacity];
    /// Change of the lattice coordinates per texel, in cells.
    alignas(64) float steps[3][capacity];
    /// Coefficients of every segment's noise, as the kind of noise defines them.
    alignas(64) float numbers[most_numbers][capacity];
};

/// sums[j] += weight * n(texel j) / stream_unit(kind) in float32 for the texels of the lines, one
/// line after the other and at most batch_capacity in all; `kind` must be value or perlin. The bits
/// do not depend on how spans are cut into pieces. n errs by at most 2.0e-7 (1 + |n|) for value
/// noise and 2.5e-7 (1 + |n|) for Perlin's against float64 at the same place (measured over 2e7
/// texels of each: 1.9e-7 and 2.2e-7, rms 3e-8).
void add_octave_scanline(NoiseKind kind, Fade fade, const StreamOctave& octave,
                         std::span<const ScanLine> lines, ScanSegments& segments, float* sums);

}  // namespace burl
