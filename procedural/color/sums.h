#pragma once
// The 1999 paper's second filter (Hart et al., section 3.3.2): a summed-area table of the colour
// map, two look-ups per mean. The program keeps it for comparison with the exact filter. The
// paper's formulas for the table's ends count one entry too many (eq. 15 and below): here a sum up
// to x is that of [0, x), so that a constant map stays constant for every f and width.
#include <array>
#include <vector>

#include "atlas/base/vec.h"
#include "procedural/color/map.h"

namespace burl {

class ColorSums {
  public:
    static constexpr int entry_count = 1024;

    /// Makes the table. `thrice` takes the paper's alternative, sums from -N to 2N instead of 0 to
    /// N, with which most footprints need no special cases; N is entry_count.
    ColorSums(const ColorMap& map, bool thrice);

    /// The mean of the table over [f - width/2, f + width/2], at least one entry wide, in linear
    /// light. The error against the exact mean is the map's variation within an entry over the
    /// number of entries that the footprint spans.
    Vec3d operator()(double f, double width) const;

    /// Element i: the sum of the entries from 0 up to, and without, entry first() + i.
    const std::vector<Vec3d>& sums() const { return sums_; }
    /// The entry that sums() begins at.
    double first() const { return first_; }
    /// The colours that stand for entries before 0 and from N on with `clamp`.
    std::array<Vec3d, 2> ends() const { return {low_, high_}; }

  private:
    Vec3d stored(double x) const;
    Vec3d sum_to(double x) const;

    Wrap wrap_;
    double first_ = 0.0;  ///< entry up to which sums_[0] is the sum
    std::vector<Vec3d> sums_;
    Vec3d low_{0.0}, high_{0.0};
};

}  // namespace burl
