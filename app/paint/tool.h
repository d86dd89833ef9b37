#pragma once
// A hand with a brush: what places on the surface, one after the other, make of a recipe's strokes.
#include <optional>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// The brush in hand; its stroke has no points.
struct PaintTool {
    bool on = false;  ///< the pointer paints
    PaintStroke brush{.radius = 0.04, .color = {0xc8, 0x2d, 0x1e}};
    bool operator==(const PaintTool&) const = default;
};

/// Radii that a hand may choose, in solid units.
inline constexpr double least_brush_radius = 0.002, largest_brush_radius = 0.5;

/// The brush larger by so many tenths, within these radii.
PaintTool resized(PaintTool tool, int tenths);

/// How far apart, in radii, places may be that one stroke leads through: farther ones are on
/// another part of the surface, behind an edge, and what is between is not what was touched.
inline constexpr double longest_lead = 2.5;

/// The recipe with the brush led on to a solid point: a new stroke at the beginning (`leads` false)
/// or where the last one is too far; the recipe as it is where the last point is hardly left.
/// Points are rounded to a millionth.
Recipe painted_at(Recipe recipe, const PaintTool& tool, const Vec3d& point, bool leads);

/// Points of a circle about `centre` in the plane with this normal.
std::vector<Vec3d> circle(const Vec3d& centre, const Vec3d& normal, double radius, int count);

}  // namespace burl
