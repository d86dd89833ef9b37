#pragma once
// The whole texturing function along a scan line by forward differences, as "Bresenham Noise"
// (Kameya & Hart, section 6) proposes: quadric and all octaves are one polynomial until the next
// cell crossing of any octave.
//
//     const std::vector<Octave> octaves = expand_octaves(recipe.texture);
//     std::vector<double> f(count);
//     forward_field(recipe.texture.quadric, octaves, {start, step, 0.0, count}, {}, f.data());
//
// f[j] is then f(start + j step), start and step in solid coordinates.
#include <span>
#include <string>

#include "procedural/bresenham/noise.h"
#include "procedural/model/octaves.h"

namespace burl {

/// The reason why f has no polynomial along a line, as the end of a sentence; empty if every octave
/// is plain value noise, which has one.
std::string no_forward_form(std::span<const Octave> octaves);

/// values[j] = f(start + (first + j) step) for j = 0 ... solid.count - 1; no_forward_form must
/// return an empty string. A texel's value does not depend on where the line is cut, only on start
/// and step. With the default longest_run, f errs by at most 4e-6 in float32, 4e-12 in float64 and
/// 4e-8 in fixed64, times 1 + Q, for noise whose amplitudes add up to 2; Q is the sum of the sizes
/// of the quadric's terms on the line.
ForwardCounts forward_field(const Quadric& quadric, std::span<const Octave> octaves,
                            const LatticeLine& solid, const ForwardOptions& options,
                            double* values);

/// The values of forward_field, from differences of the quadric and of every octave by itself
/// (add_forward_noise), added up.
ForwardCounts forward_octaves(const Quadric& quadric, std::span<const Octave> octaves,
                              const LatticeLine& solid, const ForwardOptions& options,
                              double* values);

/// The number of cell crossings per texel, of all octaves together, up to which forward_field is
/// faster than forward_octaves: its runs are then long enough to pay for polynomials of the whole
/// function (docs/reference/bresenham.md).
inline constexpr double whole_function_crossings = 0.1;

/// The values by the faster of forward_field and forward_octaves for the line's step.
ForwardCounts forward_values(const Quadric& quadric, std::span<const Octave> octaves,
                             const LatticeLine& solid, const ForwardOptions& options,
                             double* values);

}  // namespace burl
