#pragma once
// The colour map averaged over texels, by any of the filters that work on the map alone.
#include <variant>

#include "procedural/batch/filter.h"
#include "procedural/color/map_filter.h"
#include "procedural/color/mip.h"
#include "procedural/color/sums.h"

namespace burl {

class FilteredColors {
  public:
    /// Prepares the averages of a filter kind; `none` and `supersample` need no averages and count
    /// as `exact`.
    FilteredColors(const ColorMap& map, FilterKind kind);

    /// The mean of the map, in linear light, where f changes by `slope_u` and `slope_v` across the
    /// texel. Filters of one width take the box of the same variance, sqrt(slope_u^2 + slope_v^2)
    /// wide.
    Vec3d operator()(double f, double slope_u, double slope_v) const;

    /// Whether the mean is the map's exact one, and so the colour itself where the map is straight.
    bool exact() const { return std::holds_alternative<MapPieces>(map_); }
    Wrap wrap() const { return wrap_; }

  private:
    Wrap wrap_;
    bool both_axes_;
    std::variant<MapPieces, ColorMip, ColorSums> map_;
};

}  // namespace burl
