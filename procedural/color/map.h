#pragma once
// The colour map c of p = c(f): stops interpolated in linear light, index clamped or taken modulo
// one (Hart et al. 1999, eq. 2).
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

enum class Wrap { repeat, clamp };

struct ColorStop {
    double position =
        0.0;     ///< in [0,1], non-decreasing along the map; two equal positions make a jump
    Rgb8 color;  ///< sRGB
    bool operator==(const ColorStop&) const = default;
};

/// At least one stop. Between two stops the colour is interpolated in linear light. Exactly at a
/// stop it is that stop's colour; where several share a position, the last one's (so a jump belongs
/// to its right side). With `clamp` the ends go on with the first and the last colour. A negative f
/// with `repeat` has index f - floor(f). One stop is a constant. With `repeat` the interval from
/// the last stop to the first one plus one interpolates across the wrap (so a map whose first stop
/// is 0 and last is 1 jumps there, unless the colours agree).
struct ColorMap {
    Wrap wrap = Wrap::repeat;
    std::vector<ColorStop> stops;
    bool operator==(const ColorMap&) const = default;
};

/// c(f) in linear light, float64 reference.
Vec3d evaluate_color(const ColorMap& map, double f);

}  // namespace burl
