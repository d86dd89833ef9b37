#pragma once
// The colours of pbrt's marble: a spline over nine control points.
#include <array>

namespace burl {

/// Control points in linear RGB, before the multiplication by marble_brightness.
inline constexpr std::array<std::array<double, 3>, 9> marble_colors{{{.58, .58, .6},
                                                                     {.58, .58, .6},
                                                                     {.58, .58, .6},
                                                                     {.5, .5, .5},
                                                                     {.6, .59, .58},
                                                                     {.58, .58, .6},
                                                                     {.58, .58, .6},
                                                                     {.2, .2, .33},
                                                                     {.58, .58, .6}}};
/// The factor on the control points' colours.
inline constexpr double marble_brightness = 1.5;
/// The number of the spline's segments.
inline constexpr std::size_t marble_segments = marble_colors.size() - 3;

}  // namespace burl
