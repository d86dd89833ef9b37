#include "atlas/shape/occlusion.h"

#include "atlas/base/each_index.h"
#include "atlas/shape/hemisphere.h"

namespace burl {

namespace {

float openness(const ShapeScene& shape, const Hemisphere& hemisphere, const ShapePoint& point,
               float reach) {
    if (point.normal == Vec3d(0.0)) return 1.0f;
    const Vec3d place = shape.to_unit(point.position);
    const Directions directions = hemisphere.at(place, point.shading);
    const Vec3f normal(point.normal), origin(place + ray_offset * point.normal);
    int above = 0, open = 0;
    for (const Vec3f& local : directions.local) {
        const Vec3f direction = directions.frame(local);
        if (!(glm::dot(direction, normal) > 0.0f)) continue;
        ++above;
        open += !shape.rays().blocked({origin, direction}, reach);
    }
    return above > 0 ? float(open) / float(above) : 1.0f;
}

}  // namespace

void occlusion(const ShapeScene& shape, std::span<const ShapePoint> points,
               const OcclusionOptions& options, std::span<float> values) {
    const Hemisphere hemisphere(options.rays);
    const auto reach = float(options.distance / shape.diagonal());
    const auto work = [&](std::size_t i) {
        values[i] = openness(shape, hemisphere, points[i], reach);
    };
    for_each_index(points.size(), work, points_at_a_time);
}

}  // namespace burl
