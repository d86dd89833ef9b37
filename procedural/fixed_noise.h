#pragma once
// Noise in the integer arithmetic of hardware, as the simulators of 1999 and 2001 ran it (Hart et
// al., section 4.1; Carr & Hart's b_i.b_f buffers; Perlin's 8.8 noise): to see how many bits of
// texture coordinate a picture needs. Nothing is ever rounded up: bits beyond the format fall off.
#include "atlas/vec.h"
#include "procedural/noise_spec.h"

namespace burl {

/// I.F: coordinates have I integer bits, so the lattice repeats after 2^I cells, and F bits of
/// fraction; weights, random numbers and results have F bits of fraction too.
struct FixedFormat {
    unsigned integer_bits = 8;   ///< 1 to 16
    unsigned fraction_bits = 8;  ///< 2 to 16
    bool operator==(const FixedFormat&) const = default;
};

/// Whether fixed_noise knows the noise: `value` and `perlin` without period and time.
bool has_fixed_point(const NoiseSpec& noise);

/// n(p), a multiple of 2^-F. Differs from float64 (with the period 2^I) by at most 10 units of 2^-F
/// with the linear fade, 20 with the smooth one and 40 with the quintic one and for Perlin's (root
/// mean square 2, 3 and 5): the coordinates' lost bits times the slope, then a unit for every
/// product, of which the quintic's are multiplied by up to 10.
double fixed_noise(const NoiseSpec& noise, const FixedFormat& format, const Vec3d& p);

}  // namespace burl
