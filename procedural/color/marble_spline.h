#pragma once
// The colours of pbrt's marble: a spline over nine control points.
#include <array>

namespace burl {

/// Linear RGB control points, to be brightened by 1.5.
inline constexpr std::array<std::array<double, 3>, 9> marble_colors{{{.58, .58, .6},
                                                                     {.58, .58, .6},
                                                                     {.58, .58, .6},
                                                                     {.5, .5, .5},
                                                                     {.6, .59, .58},
                                                                     {.58, .58, .6},
                                                                     {.58, .58, .6},
                                                                     {.2, .2, .33},
                                                                     {.58, .58, .6}}};
inline constexpr double marble_brightness = 1.5;
inline constexpr std::size_t marble_segments = marble_colors.size() - 3;

}  // namespace burl
