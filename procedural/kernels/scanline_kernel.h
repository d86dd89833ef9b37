#pragma once
// Octaves along scan lines as what they are between two lattice planes: linear value noise a cubic
// of the texel's number, other fades and Perlin's noise a blend of eight numbers, or eight straight
// lines, by weights of places that move evenly ("Bresenham Noise", Kameya & Hart, eq. 12 and 15).
// A line's crossings are counted, not looked for, and coordinates are worked out once a cell
// instead of once a texel. That is faster than sharing corners on long lines, and rounds otherwise,
// so that it may be chosen by the line alone.
#include <span>
#include <vector>

#include "procedural/kernels/stream_kernels.h"

namespace burl {

/// Longer lines have no number of a texel that float32 could hold to the half.
inline constexpr double longest_scan_line = 0x1p22;

/// A piece in the lattice coordinates of a chain's first octave, and its span's texels: segments
/// depend on the whole span, so that pieces may begin and end anywhere.
struct ScanLine {
    LatticeLine line;
    double length = 0.0;
    Vec3d texels_per_cell{0.0};  ///< by axis; infinite where nothing moves
};

/// The pieces' lines. Those that reach lattice_limit after `doublings` on an axis stay at 0 on it,
/// as in fill_stream.
void map_scan_lines(const Affine3& lattice_from_solid, int doublings, std::span<const Piece> pieces,
                    std::vector<ScanLine>& lines);

/// Stretches of texels in one cell.
struct ScanSegments {
    static constexpr std::size_t capacity = batch_capacity + batch_padding;
    static constexpr std::size_t most_numbers = 22;
    std::size_t count = 0;
    /// One bit a texel: whether it is the first of a segment.
    static constexpr std::size_t words = batch_capacity / 64 + 1;
    std::uint64_t borders[words];
    /// Number, in the batch, of the middle of the whole stretch, of which the batch may hold a
    /// part.
    alignas(64) float middle[capacity];
    /// Of the middles: the cell, and the place from its middle in [-1/2, 1/2].
    alignas(64) std::uint32_t cells[3][capacity];
    alignas(64) float places[3][capacity];
    alignas(64) float steps[3][capacity];
    alignas(64) float numbers[most_numbers][capacity];  ///< of the octave's form
};

/// As add_octave_direct for the texels of the lines, one line after the other and at most
/// batch_capacity in all, and with the same bits however spans are cut. n errs by at most
/// 2.0e-7 (1 + |n|) for value noise and 2.5e-7 (1 + |n|) for Perlin's against float64 at the same
/// place (measured over 2e7 texels of each: 1.9e-7 and 2.2e-7, rms 3e-8).
void add_octave_scanline(NoiseKind kind, Fade fade, const StreamOctave& octave,
                         std::span<const ScanLine> lines, ScanSegments& segments, float* sums);

}  // namespace burl
