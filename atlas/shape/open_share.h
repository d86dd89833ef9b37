#pragma once
// The rays that occlusion and the light of the sky have in common.
#include <optional>

#include "atlas/shape/hemisphere.h"
#include "atlas/shape/shape_scene.h"

namespace burl {

/// The share of the hemisphere's directions at the point that `counts`(direction) holds of and that
/// meet nothing within `reach`, in diagonals; those below the triangle's plane are left out. None
/// where all directions are.
template <class Counts>
std::optional<float> open_share(const ShapeScene& shape, const Hemisphere& hemisphere,
                                const ShapePoint& point, float reach, const Counts& counts) {
    const Vec3d place = shape.to_unit(point.position);
    const Directions directions = hemisphere.at(place, point.shading);
    const Vec3f normal(point.normal), origin(place + ray_offset * point.normal);
    int above = 0, open = 0;
    for (const Vec3f& local : directions.local) {
        const Vec3f direction = directions.frame(local);
        if (!(glm::dot(direction, normal) > 0.0f)) continue;
        ++above;
        open += counts(direction) && !shape.rays().blocked({origin, direction}, reach);
    }
    if (above == 0) return {};
    return float(open) / float(above);
}

}  // namespace burl
