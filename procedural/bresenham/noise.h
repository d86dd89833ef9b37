#pragma once
// "Bresenham Noise" (Kameya & Hart): value noise along a scan line by forward differences, which
// start anew in every lattice cell that the line enters.
//
//     std::vector<double> n(count, 0.0);
//     const LatticeLine line{start, step, 0.0, count};     // in lattice coordinates, per texel
//     add_forward_noise({.fade = Fade::linear, .seed = 7}, 1.0, line, {}, n.data());
//
// n[j] is then noise at start + j step, in [-1, 1) (the papers' noise is (n + 1) / 2). field.h has
// the whole texturing function.
#include <cstdint>
#include <string>

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/spec.h"

namespace burl {

/// The arithmetic in which differences are added. Their first values always come from float64.
enum class ForwardPrecision { float32, float64, fixed64 };

/// Options of forward differencing.
struct ForwardOptions {
    ForwardPrecision precision = ForwardPrecision::float64;
    /// The number of texels within a cell after which differences start anew, because errors grow
    /// with it; 0 takes longest_run(), 2^62 never starts anew.
    std::int64_t longest_run = 0;
};

/// Counts of the work that a line took.
struct ForwardCounts {
    std::int64_t cells = 0;   ///< cells entered by all octaves, with eight corners hashed for each
    std::int64_t runs = 0;    ///< sets of differences computed
    std::int64_t direct = 0;  ///< texels evaluated singly: their stretch is too short
    ForwardCounts& operator+=(const ForwardCounts& more);
    bool operator==(const ForwardCounts&) const = default;
};

/// The default number of texels for one set of differences of a polynomial of this degree (3, 9 or
/// 15), when the fastest coordinate moves by `cells_per_texel`.
std::int64_t longest_run(std::size_t degree, ForwardPrecision precision, double cells_per_texel);

/// The reason why the noise has no polynomial along a line, as the end of a sentence; empty for
/// value noise of three dimensions, which has one.
std::string no_forward_form(const NoiseSpec& noise);

/// sums[j] += scale * n(start + (first + j) step) for j = 0 ... line.count - 1. A texel's value
/// does not depend on where the line is cut, only on start and step. no_forward_form must return an
/// empty string, and the line's coordinates must be below lattice_limit. With the default
/// longest_run, n errs against float64 at the same point by at most 2.5e-6 in float32, 4e-12 in
/// float64 and 2.5e-8 in fixed64, at any step and length and with any fade (measured: 2.1e-6, 2e-12
/// and 1.2e-8), plus 2^-50 times the coordinate's size.
ForwardCounts add_forward_noise(const NoiseSpec& noise, double scale, const LatticeLine& line,
                                const ForwardOptions& options, double* sums);

}  // namespace burl
