#pragma once
// "Bresenham Noise" (Kameya & Hart): value noise along a scan line by forward differences, which
// start anew in every lattice cell the line enters.
//
//     std::vector<double> n(count, 0.0);
//     const LatticeLine line{start, step, 0.0, count};     // in lattice coordinates, per texel
//     add_forward_noise({.fade = Fade::linear, .seed = 7}, 1.0, line, {}, n.data());
//
// n[j] is then noise at start + j step, in [-1, 1) (the papers' noise is (n + 1) / 2). The whole
// texturing function is forward_field.h.
#include <cstdint>
#include <string>

#include "procedural/batch/texel_batch.h"
#include "procedural/noise/spec.h"

namespace burl {

/// What differences are added in. Their first values always come from float64.
enum class ForwardPrecision { float32, float64, fixed64 };

struct ForwardOptions {
    ForwardPrecision precision = ForwardPrecision::float64;
    /// Differences start anew after so many texels within a cell, too, because errors grow with the
    /// texels; 0 takes longest_run(), and 2^62 never does.
    std::int64_t longest_run = 0;
};

/// What a line took.
struct ForwardCounts {
    std::int64_t cells = 0;   ///< cells entered, of all octaves: eight corners hashed for each
    std::int64_t runs = 0;    ///< sets of differences computed
    std::int64_t direct = 0;  ///< texels evaluated by themselves, their stretch of a cell too short
    ForwardCounts& operator+=(const ForwardCounts& more);
    bool operator==(const ForwardCounts&) const = default;
};

/// Texels that differences of a polynomial of so high a degree (3, 9 or 15) run on by default, when
/// the fastest coordinate moves by `cells_per_texel`.
std::int64_t longest_run(std::size_t degree, ForwardPrecision precision, double cells_per_texel);

/// Why the noise has no polynomial along a line, as the end of a sentence; empty if it has one:
/// value noise of three dimensions.
std::string no_forward_form(const NoiseSpec& noise);

/// sums[j] += scale * n(start + (first + j) step) for j = 0 ... line.count - 1. A texel's value
/// does not depend on where the line is cut, only on start and step. no_forward_form must be empty,
/// line coordinates below lattice_limit. With the default longest_run, n errs against float64 at
/// the same point by at most 2.5e-6 in float32, 4e-12 in float64 and 2.5e-8 in fixed64, at any step
/// and length and with any fade (measured: 2.1e-6, 2e-12 and 1.2e-8), plus 2^-50 times the
/// coordinate's size.
ForwardCounts add_forward_noise(const NoiseSpec& noise, double scale, const LatticeLine& line,
                                const ForwardOptions& options, double* sums);

}  // namespace burl
