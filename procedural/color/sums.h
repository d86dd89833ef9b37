#pragma once
// The 1999 paper's second filter (Hart et al., section 3.3.2): a summed-area table of the colour
// map, two look-ups per mean. Kept for comparison with the exact filter. The paper's formulas for
// the table's ends count one entry too many (eq. 15 and below): here a sum up to x is that of
// [0, x), so that a constant map stays constant for every f and width.
#include <array>
#include <vector>

#include "atlas/base/vec.h"
#include "procedural/color/map.h"

namespace burl {

class ColorSums {
  public:
    static constexpr int entry_count = 1024;

    /// `thrice`: the paper's alternative, sums from -N to 2N made beforehand, so that most
    /// footprints need no special cases.
    ColorSums(const ColorMap& map, bool thrice);

    /// Mean of the table over [f - width/2, f + width/2], at least one entry wide, linear light.
    /// Error against the exact mean: the map's variation within an entry over the number of entries
    /// that the footprint spans.
    Vec3d operator()(double f, double width) const;

    /// Of all entries before first() + i, from entry 0 on.
    const std::vector<Vec3d>& sums() const { return sums_; }
    double first() const { return first_; }
    /// Entries before 0 and from N on with `clamp`.
    std::array<Vec3d, 2> ends() const { return {low_, high_}; }

  private:
    Vec3d stored(double x) const;
    Vec3d sum_to(double x) const;

    Wrap wrap_;
    double first_ = 0.0;  ///< sums_[0] is the sum up to here, in entries
    std::vector<Vec3d> sums_;
    Vec3d low_{0.0}, high_{0.0};
};

}  // namespace burl
