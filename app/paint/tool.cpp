#include "app/paint/tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace burl {

namespace {

/// The least and the largest distance between successive points of a stroke, in radii.
constexpr double spacing = 0.2, longest_lead = 2.5;
constexpr double steps_per_unit = 1e6;

Vec3d rounded(const Vec3d& point) {
    return glm::round(point * steps_per_unit) / steps_per_unit;
}

}  // namespace

PaintTool resized(PaintTool tool, int tenths) {
    tool.brush.radius = std::clamp(tool.brush.radius * std::pow(1.1, tenths), least_brush_radius,
                                   largest_brush_radius);
    return tool;
}

Recipe painted_at(Recipe recipe, const PaintTool& tool, const Vec3d& point, bool leads) {
    const Vec3d at = rounded(point);
    const double radius = tool.brush.radius;
    const bool empty = recipe.paint.empty() || recipe.paint.back().points.empty();
    const double away = empty ? 0.0 : glm::distance(recipe.paint.back().points.back(), at);
    if (leads && !empty && away < spacing * radius) return recipe;
    if (!leads || empty || away > longest_lead * radius) recipe.paint.push_back(tool.brush);
    recipe.paint.back().points.push_back(at);
    return recipe;
}

std::vector<Vec3d> circle(const Vec3d& centre, const Vec3d& normal, double radius, int count) {
    const Vec3d aside =
        std::abs(normal.x) < 0.6 * glm::length(normal) ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d u = glm::normalize(glm::cross(normal, aside)),
                v = glm::normalize(glm::cross(normal, u));
    std::vector<Vec3d> points;
    for (int i = 0; i < count; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / count;
        points.push_back(centre + radius * (std::cos(turn) * u + std::sin(turn) * v));
    }
    return points;
}

}  // namespace burl
