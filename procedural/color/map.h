#pragma once
// The colour map c of p = c(f): stops interpolated in linear light, the index clamped or taken
// modulo one (Hart et al. 1999, eq. 2).
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/base/enum_names.h"
#include "atlas/base/image.h"
#include "atlas/base/vec.h"

namespace burl {

/// The index of f outside [0, 1): f modulo one, or f clamped to [0, 1].
enum class Wrap { repeat, clamp };
template <>
inline constexpr auto enum_names<Wrap> = enum_words("repeat", "clamp");

/// A colour at a position of the map.
struct ColorStop {
    /// A position in [0, 1], non-decreasing along the map; two equal positions make a jump.
    double position = 0.0;
    Rgb8 color;                ///< sRGB-encoded, not multiplied by alpha
    std::uint8_t alpha = 255;  ///< 0 (transparent) to 255 (opaque), linear
    bool operator==(const ColorStop&) const = default;
};

/// The colour of a stop in linear light, multiplied by its alpha.
Vec3d light_of(const ColorStop& stop);

/// A colour map of at least one stop. Between two stops the colour is interpolated in linear light,
/// multiplied by its alpha, and so is alpha: a transparent stop has no colour that could show.
/// Exactly at a stop it is that stop's colour; where several share a position, the last one's (so a
/// jump belongs to its right side). One stop is a constant. With `clamp` the ends go on with the
/// first and the last colour. With `repeat` the index of f is f - floor(f), and the interval from
/// the last stop to the first one plus one interpolates across the wrap (so a map whose first stop
/// is 0 and last is 1 jumps there, unless the colours agree).
struct ColorMap {
    Wrap wrap = Wrap::repeat;
    std::vector<ColorStop> stops;
    bool operator==(const ColorMap&) const = default;
};

/// c(f) in linear light, multiplied by alpha: the float64 reference.
Vec3d evaluate_color(const ColorMap& map, double f);

/// Whether every stop of the map is opaque.
bool is_opaque(const ColorMap& map);

/// The map whose red, green and blue are all the alpha of `map`. Means of it are means of alpha, by
/// whatever filter.
ColorMap alpha_map(ColorMap map);

}  // namespace burl
