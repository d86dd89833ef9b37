#pragma once
// The texture's field f (Hart et al. 1999, eq. 1) in the integers of hardware: texture coordinates,
// lattice coordinates, weights, random numbers, products and sums have I.F bits
// (batch/precision.h), the recipe's own numbers (frequencies, amplitudes, coefficients) all their
// bits, so that a picture shows the effect of the running values' precision.
//
// Coordinates that leave the range wrap, so that the lattice repeats after 2^I cells; sums saturate
// at the range's ends, as the frame buffers of 2001 did. All rounding is downwards.
#include <vector>

#include "procedural/batch/texel_batch.h"
#include "procedural/fixed/noise.h"
#include "procedural/model/octaves.h"

namespace burl {

/// Whether every term of the texture has noise in fixed point.
bool has_fixed_point(const Texture& texture);

class FixedField {
  public:
    /// The field of a texture for which has_fixed_point holds.
    FixedField(const Texture& texture, const FixedFormat& format);

    /// f(s), a multiple of 2^-F. While nothing leaves the range, its difference from float64, in
    /// units of 2^-F, is at most a number that depends on the texture and |s| alone. The bound is
    /// the sum of: f's slope along each axis (from rounding s); |s| + 1 per axis of the quadric;
    /// and per octave 1 plus its amplitude times (fixed_noise's error plus the noise's slope along
    /// each axis).
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

/// The value of f at a point, and its changes along the two sides of a footprint there.
struct FixedSpread {
    double value = 0.0, u = 0.0, v = 0.0;
};

/// The spread that decides about a filter's width. Fixed point has no gradients, so the changes are
/// differences to the points one side further, in the same integers: one below 2^-F is 0, and none
/// exceeds the range of f.
FixedSpread spread_over(const FixedField& field, const Vec3d& s, const Footprint& sides);

}  // namespace burl
