#include "atlas/shape/occlusion.h"

#include "atlas/base/each_index.h"
#include "atlas/shape/open_share.h"

namespace burl {

namespace {

float openness(const ShapeScene& shape, const Hemisphere& hemisphere, const ShapePoint& point,
               float reach) {
    if (point.normal == Vec3d(0.0)) return 1.0f;
    const auto all = [](const Vec3f&) { return true; };
    return open_share(shape, hemisphere, point, reach, all).value_or(1.0f);
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
