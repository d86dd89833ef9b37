#pragma once
// What a bake is held against where float64 itself is in doubt: the 1999 model's field written once
// more, straight from docs/noise.md and in long double, and the error that docs/numerics.md allows.
#include <array>
#include <string>
#include <vector>

#include "atlas/solid_atlas.h"
#include "procedural/octaves.h"

namespace burl {

class StabilityTruth {
  public:
    using Point = std::array<long double, 3>;

    StabilityTruth(const Texture& texture, const Affine3& texture_from_atlas);

    /// Where a texel's centre lies in the texture, from its map's own numbers without rounding.
    Point point(const TexelMap& map, std::int64_t x, std::int64_t y) const;

    /// f there. Noises other than `value` and `perlin` without period and time are those of
    /// noise.h in float64.
    long double field(const Point& s) const;

    /// c(f), linear light, with f's index taken in long double.
    Vec3d color(long double f) const;

    /// What |f - field| may be anywhere on a span whose rounding is that of its farthest texel:
    /// 2.5e-7 (|f| + sum |a_k|) + 4 * 2^-52 (max|T_k s| sum |a_k| + the quadric's terms' sizes),
    /// and for octaves that are no plain `value` or `perlin` 5e-7 |a_k|, twice that for ridges.
    double bound(const Span& span, const TexelMap& map, std::int64_t y, double f) const;
    /// The last of it alone: what rounding in float64 may do to f.
    double rounding(const Span& span, const TexelMap& map, std::int64_t y) const;
    double amplitudes() const { return amplitudes_; }

  private:
    Texture texture_;
    Affine3 map_;
    std::vector<Octave> octaves_;
    double amplitudes_ = 0.0, other_errors_ = 0.0;
};

}  // namespace burl
