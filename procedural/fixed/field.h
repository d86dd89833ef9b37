#pragma once
// The texture's field f (Hart et al. 1999, eq. 1) in integers as hardware would run it: texture
// coordinates, lattice coordinates, weights, random numbers, products and sums have I.F bits
// (precision.h), the recipe's own numbers (frequencies, amplitudes, coefficients) all their bits,
// so that what is seen is what the running values lack.
//
// Coordinates that leave the range wrap, so that the lattice repeats after 2^I cells; sums stop at
// the range's ends, as the frame buffers of 2001 did. Nothing is rounded up.
#include <vector>

#include "procedural/fixed/noise.h"
#include "procedural/model/octaves.h"

namespace burl {

/// Whether every term of the texture has noise in fixed point.
bool has_fixed_point(const Texture& texture);

class FixedField {
  public:
    /// has_fixed_point(texture) must hold.
    FixedField(const Texture& texture, const FixedFormat& format);

    /// f(s), a multiple of 2^-F. As long as nothing leaves the range it differs from float64 by at
    /// most a number of units of 2^-F that depends on the texture and |s| alone, which is the sum
    /// of: f's slope along each axis (of cutting s); |s| + 1 per axis of the quadric; and per
    /// octave its amplitude times (fixed_noise's error and the noise's slope along each axis),
    /// and 1.
    double operator()(const Vec3d& s) const;

  private:
    FixedInteger quadric(const std::array<FixedInteger, 3>& s) const;
    FixedInteger octave(const Octave& octave, const std::array<FixedInteger, 3>& s) const;
    FixedInteger stopped(FixedInteger units) const;
    FixedInteger stopped(double units) const;
    double units(double x) const;

    FixedFormat format_;
    Quadric quadric_;
    std::vector<Octave> octaves_;
    FixedInteger constant_ = 0;
};

}  // namespace burl
