#pragma once
// What a bake is held against where float64 itself is in doubt: the 1999 model's field written once
// more, straight from docs/reference/noise.md and in long double, and the errors that
// docs/reference/numerics.md allows.
#include <vector>

#include "app/bench/stability_noise.h"
#include "atlas/solid/solid_atlas.h"
#include "procedural/model/octaves.h"

namespace burl {

/// How large the numbers become that a span's texels are made of.
struct SpanSizes {
    double lattice = 0.0;  ///< the largest lattice coordinate of any octave
    double quadric = 0.0;  ///< the quadric's terms, added up without their signs
};

class StabilityTruth {
  public:
    StabilityTruth(const Texture& texture, const Affine3& texture_from_atlas);

    /// Where a texel's centre lies in the texture, from its map's own numbers without rounding.
    LongPoint point(const TexelMap& map, std::int64_t x, std::int64_t y) const;

    /// f there. Noises without a long form (stability_noise.h) are those of noise.h in float64.
    long double field(const LongPoint& s) const;
    /// f with its gradient with respect to s.
    LongNoise sample(const LongPoint& s) const;

    /// |got - f(s)|. Where octaves jump, the least of it over the sides of a jump that s may be
    /// taken to lie on, if lattice coordinates are rounded by 4 * 2^-52 of their size and
    /// `place_error` of a cell.
    double error(const LongPoint& s, double got, const SpanSizes& sizes, double place_error) const;

    SpanSizes sizes(const Span& span, const TexelMap& map, std::int64_t y) const;
    /// What rounding in float64 may do to f: 4 * 2^-52 (max|T_k s| sum |a_k| + the quadric's
    /// terms' sizes).
    double rounding(const SpanSizes& sizes) const;
    double amplitudes() const { return amplitudes_; }
    /// What some octaves may err by besides in float32, as a share of |a_k|: ridged ones, whose
    /// slope is up to twice the noise's, 2.5e-7, and simplex noise that no kernel knows 2.5e-7, in
    /// four dimensions, where its sum is 62 times its kernels', 7.5e-7.
    double special_errors() const { return special_errors_; }
    const Texture& texture() const { return texture_; }
    const std::vector<Octave>& octaves() const { return octaves_; }
    const Affine3& map() const { return map_; }

  private:
    long double from_side(const LongPoint& s, const LongPoint& side) const;

    Texture texture_;
    Affine3 map_;
    std::vector<Octave> octaves_;
    double amplitudes_ = 0.0, special_errors_ = 0.0;
    bool jumps_ = false;
};

/// The texture's map, linear light, at a field value, its index taken in long double.
Vec3d long_color(const ColorMap& map, long double f);

}  // namespace burl
