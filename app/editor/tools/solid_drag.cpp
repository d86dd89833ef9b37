#include "app/editor/tools/solid_drag.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "app/base/rotation_angles.h"
#include "procedural/numbers/rotation.h"

namespace burl {

namespace {

constexpr double step_radians = std::numbers::pi / 36.0, step_size = 1.05;
// Ranges that recipes accept.
constexpr double least_scale = 1e-6, largest_scale = 1e6, farthest = 1e6;

double tidy(double value) {
    const std::string text = fmt::format("{:.10g}", value);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value + 0.0;  // turns -0 into 0
}

Vec3d tidy(const Vec3d& v) {
    return {tidy(v.x), tidy(v.y), tidy(v.z)};
}

Vec3d texture_point(const SolidOptions& solid, const Vec3d& at) {
    return solid.scale * (rotation_about_axes(solid.rotate) * at) + solid.translate;
}

/// Returns `solid` translated so that it shows the texture's point `shown` at `at`.
SolidOptions showing(SolidOptions solid, const Vec3d& at, const Vec3d& shown) {
    solid.translate = Vec3d(0.0);
    const Vec3d offset = tidy(shown - texture_point(solid, at));
    solid.translate = glm::clamp(offset, Vec3d(-farthest), Vec3d(farthest));
    return solid;
}

Vec3d aimed(const DragPivot& pivot, const Vec3d& at) {
    const Vec3d d = at - pivot.point;
    const double lift = pivot.reach * pivot.reach - glm::dot(d, d);
    return lift > 0.0 ? d + std::sqrt(lift) * pivot.viewer : d;
}

double distance(const DragPivot& pivot, const Vec3d& at) {
    return std::max(glm::distance(at, pivot.point), pivot.reach);
}

}  // namespace

SolidOptions moved(SolidOptions solid, const Vec3d& offset) {
    return showing(solid, offset, texture_point(solid, Vec3d(0.0)));
}

SolidOptions turned(SolidOptions solid, const Vec3d& pivot, const Mat3d& turn) {
    const Vec3d shown = texture_point(solid, pivot);
    const Mat3d rotation = rotation_about_axes(solid.rotate) * glm::transpose(turn);
    solid.rotate = tidy(angles_of(rotation, solid.rotate));
    return showing(solid, pivot, shown);
}

SolidOptions enlarged(SolidOptions solid, const Vec3d& pivot, double factor) {
    const Vec3d shown = texture_point(solid, pivot);
    solid.scale = tidy(std::clamp(solid.scale / factor, least_scale, largest_scale));
    return showing(solid, pivot, shown);
}

SolidOptions dragged(const SolidOptions& start, SolidDrag drag, const DragPivot& pivot,
                     const Vec3d& from, const Vec3d& to) {
    if (from == to) return start;
    switch (drag) {
        case SolidDrag::move:
            return moved(start, to - from);
        case SolidDrag::turn:
            return turned(start, pivot.point, turn_between(aimed(pivot, from), aimed(pivot, to)));
        case SolidDrag::size: {
            const double before = distance(pivot, from);
            return before > 0.0 ? enlarged(start, pivot.point, distance(pivot, to) / before)
                                : start;
        }
    }
    return start;
}

SolidOptions stepped(const SolidOptions& start, SolidDrag drag, const Camera& camera,
                     const Vec3d& pivot, const Vec2d& way, double distance) {
    const Vec3d line = way.x * camera.up - way.y * camera.right;
    switch (drag) {
        case SolidDrag::move:
            return moved(start, distance * (way.x * camera.right + way.y * camera.up));
        case SolidDrag::turn:
            return turned(start, pivot, turn_about(line, step_radians));
        case SolidDrag::size:
            return enlarged(start, pivot, std::pow(step_size, way.x + way.y));
    }
    return start;
}

Vec3d beside(const Camera& camera, const Ray& ray, const Vec3d& through) {
    return ray.at(glm::dot(camera.eye - through, camera.back));
}

}  // namespace burl
