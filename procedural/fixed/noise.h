#pragma once
// Noise in the integer arithmetic of hardware, as the simulators of 1999 and 2001 computed it (Hart
// et al., section 4.1; Carr & Hart's b_i.b_f buffers; Perlin's 8.8 noise), to see how many bits of
// texture coordinate a picture needs. All rounding is downwards: bits beyond the format are
// dropped.
#include <array>

#include "atlas/base/vec.h"
#include "procedural/batch/precision.h"
#include "procedural/noise/spec.h"

namespace burl {

/// A number in units of 2^-F.
using FixedInteger = std::int64_t;

/// x rounded down to the format and wrapped into its range. Numbers too large for a double to have
/// a fraction (lattice_limit), and NaN, count as 0.
FixedInteger fixed_coordinate(double x, const FixedFormat& format);

/// The units rounded down and taken modulo 2^(I+F) into [-2^(I+F-1), 2^(I+F-1)).
FixedInteger wrapped_units(double units, const FixedFormat& format);

/// Whether fixed_noise has the noise: `value` and `perlin` without period and time.
bool has_fixed_point(const NoiseSpec& noise);

/// n(p), p and n in units of 2^-F. Within the format's range, less the last cell, whose upper
/// corners are those of the first one (the lattice repeats after 2^I cells), n differs from float64
/// by at most 10 units with the linear fade, 20 with the smooth one and 40 with the quintic one and
/// for Perlin's noise (root mean square 2, 3 and 5): the coordinates' lost bits times the slope,
/// then a unit for every product, of which the quintic's are multiplied by up to 10.
FixedInteger fixed_noise_units(const NoiseSpec& noise, const FixedFormat& format,
                               const std::array<FixedInteger, 3>& p);

/// fixed_noise_units at fixed_coordinate of p, as a number: a multiple of 2^-F.
double fixed_noise(const NoiseSpec& noise, const FixedFormat& format, const Vec3d& p);

}  // namespace burl
