#pragma once
// The reference for bakes where float64 itself is in doubt: a second implementation of noise,
// its gradient and the 1999 model's field, directly from docs/reference/noise.md and in long
// double, and the error bounds of docs/reference/numerics.md.
#include <array>
#include <vector>

#include "atlas/solid/solid_atlas.h"
#include "procedural/model/octaves.h"
#include "procedural/noise/spec.h"

namespace burl {

using LongPoint = std::array<long double, 3>;

/// A noise's value and gradient.
struct LongNoise {
    long double value = 0.0L;
    LongPoint gradient{};
};

/// Whether long_noise() implements the noise itself: `value`, `perlin` and `simplex` without period
/// and time.
bool has_long_form(const NoiseSpec& noise);

/// Returns value and gradient at p, in lattice coordinates. Other noises are evaluated by
/// procedural/noise/noise.h in float64, at p rounded to float64.
LongNoise long_noise(const NoiseSpec& noise, const LongPoint& p);

/// Whether the noise is discontinuous: there, the rounding of a point decides its side.
bool has_jumps(const NoiseSpec& noise);

/// Magnitudes of the numbers from which a span's texels are computed.
struct SpanSizes {
    double lattice = 0.0;  ///< largest lattice coordinate of any octave
    double quadric = 0.0;  ///< sum of the magnitudes of the quadric's terms
};

/// The field of a texture in long double.
class StabilityTruth {
  public:
    StabilityTruth(const Texture& texture, const Affine3& texture_from_atlas);

    /// Returns a texel's centre in texture coordinates, from the numbers of its map without
    /// rounding.
    LongPoint point(const TexelMap& map, std::int64_t x, std::int64_t y) const;

    /// Returns f(s). Noises without a long form are evaluated in float64.
    long double field(const LongPoint& s) const;
    /// Returns f(s) and its gradient with respect to s.
    LongNoise sample(const LongPoint& s) const;

    /// Returns |got - f(s)|. Where octaves jump, it is the least of this over the sides of the jump
    /// on which s may lie when lattice coordinates are rounded by 4 * 2^-52 of their size and by
    /// `place_error` of a cell.
    double error(const LongPoint& s, double got, const SpanSizes& sizes, double place_error) const;

    /// Returns the magnitudes of the numbers in a span of row y.
    SpanSizes sizes(const Span& span, const TexelMap& map, std::int64_t y) const;
    /// Returns the bound on the rounding error of f in float64: 4 * 2^-52 (max|T_k s| sum |a_k| +
    /// the magnitudes of the quadric's terms).
    double rounding(const SpanSizes& sizes) const;
    /// The sum of |a_k| and of the octaves' |offsets|.
    double amplitudes() const { return amplitudes_; }
    /// The additional error bound of some octaves in float32, the sum of shares of |a_k|: 2.5e-7
    /// for ridged ones, whose slope is up to twice the noise's; 2.5e-7 for simplex noise without a
    /// kernel; and 7.5e-7 for it in four dimensions, where its sum is 62 times that of the kernels.
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

/// Returns the map's colour at a field value in linear light; its index is computed in long double.
Vec3d long_color(const ColorMap& map, long double f);

}  // namespace burl
