#pragma once
// A brush in a user's hand: how successive points on the surface extend a recipe's strokes.
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// The state of the paint tool; its brush is a stroke without points.
struct PaintTool {
    bool on = false;  ///< whether the pointer paints
    PaintStroke brush{.radius = 0.04, .color = {0xc8, 0x2d, 0x1e}};
    bool operator==(const PaintTool&) const = default;
};

/// The range of the brush radius, in solid units.
inline constexpr double least_brush_radius = 0.002, largest_brush_radius = 0.5;

/// The tool with its radius multiplied by 1.1^tenths, within the range of radii.
PaintTool resized(PaintTool tool, int tenths);

/// The recipe with the brush moved to a solid point. A new stroke begins where `leads` is false or
/// the last point is farther than 2.5 radii: on another part of the surface, behind an edge, and
/// the surface in between was not touched. Otherwise the recipe is unchanged where the last point
/// is nearer than 0.2 radii. Points are rounded to 1e-6.
Recipe painted_at(Recipe recipe, const PaintTool& tool, const Vec3d& point, bool leads);

/// `count` points of a circle about `centre` in the plane with this normal, of any length but 0.
std::vector<Vec3d> circle(const Vec3d& centre, const Vec3d& normal, double radius, int count);

}  // namespace burl
