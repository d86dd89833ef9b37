#include "atlas/chart/planar_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "atlas/chart/covering.h"
#include "atlas/chart/least_rectangle.h"

namespace burl {
namespace {

constexpr double least_flatness = 0.9999, most_thickness = 0.002;
/// Share of a patch's lesser side to which it may cover places twice, where that is less than
/// `most_overlap`: of a patch as thin as rounding two triangles could lie on each other whole.
constexpr double most_share = 0.25;

Vec3d doubled_area(const Patch& patch, std::size_t t) {
    const Triangle& v = patch.triangles[t];
    return glm::cross(patch.points[v[1]] - patch.points[v[0]],
                      patch.points[v[2]] - patch.points[v[0]]);
}

/// The unit normal of the patch's plane; nothing when the patch is not flat or folds over itself.
std::optional<Vec3d> plane_normal(const Patch& patch) {
    Vec3d sum(0.0);
    double area = 0.0;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        sum += doubled_area(patch, t);
        area += glm::length(doubled_area(patch, t));
    }
    const double length = glm::length(sum);
    if (!(length > 0.0) || length < least_flatness * area) return std::nullopt;
    const Vec3d normal = sum / length;
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const Vec3d& p : patch.points) {
        const double height = glm::dot(p - patch.points[0], normal);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (high - low > most_thickness * std::sqrt(0.5 * area)) return std::nullopt;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
        if (glm::dot(doubled_area(patch, t), normal) < 0.0) return std::nullopt;
    return normal;
}

}  // namespace

std::optional<PlanarMap> map_planar(const Patch& patch) {
    const auto normal = plane_normal(patch);
    if (!normal) return std::nullopt;
    const Vec3d helper = std::abs(normal->x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
    const Vec3d a = glm::normalize(glm::cross(helper, *normal)), b = glm::cross(*normal, a);
    std::vector<Vec2d> flat;
    for (const Vec3d& p : patch.points)
        flat.emplace_back(glm::dot(p - patch.points[0], a), glm::dot(p - patch.points[0], b));
    const TurnedRectangle r = least_rectangle(convex_hull(flat));
    const double area = area_of(patch);
    const Vec2d size = r.high - r.low;
    if (!(size.x > 0.0) || !(size.y > 0.0) || area > r.area() * (1.0 + 1e-6)) return std::nullopt;
    const double overlap = std::min(most_overlap, most_share * std::min(size.x, size.y));
    if (covers_twice(patch, flat, overlap)) return std::nullopt;
    PlanarMap map;
    for (const Vec2d& p : flat)
        map.uv.push_back((Vec2d(glm::dot(p, r.axis), cross(r.axis, p)) - r.low) / size);
    const Vec3d u = r.axis.x * a + r.axis.y * b, v = -r.axis.y * a + r.axis.x * b;
    map.origin = patch.points[0] + r.low.x * u + r.low.y * v;
    map.along_u = size.x * u;
    map.along_v = size.y * v;
    map.stretch = {area * size.x * size.x, area * size.y * size.y, area};
    return map;
}

}  // namespace burl
