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

/// Why f has no polynomial along a line, as the end of a sentence; empty if it has one: plain value
/// noise in every octave.
std::string no_forward_form(std::span<const Octave> octaves);

/// values[j] = f(start + (first + j) step) for j = 0 ... line.count - 1; no_forward_form must be
/// empty. A texel's value does not depend on where the line is cut, only on start and step. With
/// the default longest_run, f errs by at most 4e-6, 4e-12 and 4e-8 times 1 + Q for noise whose
/// amplitudes add up to 2, Q the sizes of the quadric's terms on the line, added up.
ForwardCounts forward_field(const Quadric& quadric, std::span<const Octave> octaves,
                            const LatticeLine& solid, const ForwardOptions& options,
                            double* values);

/// The same f from the quadric and every octave by themselves (add_forward_noise), added up.
ForwardCounts forward_octaves(const Quadric& quadric, std::span<const Octave> octaves,
                              const LatticeLine& solid, const ForwardOptions& options,
                              double* values);

/// Cell crossings per texel, of all octaves together, up to which forward_field is the faster of
/// the two: below, its runs are long enough to pay for polynomials of everything
/// (docs/reference/bresenham.md).
inline constexpr double whole_function_crossings = 0.1;

/// The faster of the two for the line's step.
ForwardCounts forward_values(const Quadric& quadric, std::span<const Octave> octaves,
                             const LatticeLine& solid, const ForwardOptions& options,
                             double* values);

}  // namespace burl
