#include "atlas/shape/thickness.h"

#include <algorithm>

#include "atlas/base/each_index.h"
#include "atlas/shape/hemisphere.h"

namespace burl {

namespace {

/// Length of the ray from `place` to the plane of the triangle that it met, in double: Embree's own
/// has the rounding of a float.
double length_to(const ShapeScene& shape, std::uint32_t triangle, const Vec3d& place,
                 const Vec3d& direction, double cap) {
    const Vec3d& normal = shape.normals()[triangle];
    const Vec3d& corner = shape.points()[shape.triangles()[triangle][0]];
    const double length = glm::dot(normal, corner - place) / glm::dot(normal, direction);
    return length >= 0.0 ? std::min(length, cap) : 0.0;  // 0 on a triangle without area, too
}

double depth(const ShapeScene& shape, const Hemisphere& hemisphere, const ShapePoint& point,
             double cap) {
    if (point.normal == Vec3d(0.0)) return 0.0;
    const Vec3d place = shape.to_unit(point.position);
    const Directions directions = hemisphere.at(place, -point.shading);
    const Vec3f normal(point.normal), origin(place - ray_offset * point.normal);
    int below = 0;
    double sum = 0.0;
    for (const Vec3f& local : directions.local) {
        const Vec3f direction = directions.frame(local);
        if (!(glm::dot(direction, normal) < 0.0f)) continue;
        ++below;
        const std::uint32_t met = shape.rays().nearest({origin, direction}, float(cap));
        sum += met == nothing_met ? cap : length_to(shape, met, place, Vec3d(direction), cap);
    }
    return below > 0 ? sum / below : 0.0;
}

}  // namespace

void thickness(const ShapeScene& shape, std::span<const ShapePoint> points,
               const ThicknessOptions& options, std::span<float> values) {
    const Hemisphere hemisphere(options.rays);
    const double cap = std::clamp(options.distance / shape.diagonal(), 0.0, 1.0);
    const auto work = [&](std::size_t i) {
        values[i] = float(shape.diagonal() * depth(shape, hemisphere, points[i], cap));
    };
    for_each_index(points.size(), work, points_at_a_time);
}

}  // namespace burl
