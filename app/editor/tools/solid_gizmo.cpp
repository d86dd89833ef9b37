#include "app/editor/tools/solid_gizmo.h"

#include <algorithm>
#include <cmath>

#include "app/base/rotation_angles.h"
#include "app/editor/tools/solid_drag.h"
#include "app/paint/tool.h"
#include "app/scene/camera.h"
#include "procedural/numbers/rotation.h"

namespace burl {

namespace {

constexpr int ring_sides = 64;
constexpr double end_on = 18.0;  // an arrow shorter than so many pixels cannot be dragged
constexpr double edge_on = 0.2;  // a ring seen at an angle with a smaller sine is seen edge on
constexpr double grip = 0.35;    // start of an arrow as a share of its length, clear of the square
constexpr double doubling = 100.0;  // pixels that double the texture's size

Vec2d seen(const GizmoView& view, const Vec3d& point) {
    return Vec2d(project(view.camera, view.size, point));
}

double distance_to(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
    const Vec2d d = b - a;
    const double square = glm::dot(d, d);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - a, d) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * d);
}

double distance_to_ring(const SolidGizmo& gizmo, const GizmoView& view, int axis, const Vec2d& p) {
    const std::vector<Vec3d> ring = ring_points(gizmo, axis);
    double nearest = HUGE_VAL;
    for (std::size_t i = 0; i < ring.size(); ++i)
        nearest = std::min(
            nearest, distance_to(p, seen(view, ring[i]), seen(view, ring[(i + 1) % ring.size()])));
    return nearest;
}

double distance_to_square(const SolidGizmo& gizmo, const GizmoView& view, const Vec2d& p) {
    const Vec2d d = glm::abs(p - seen(view, gizmo.centre));
    return std::max({d.x - gizmo_square, d.y - gizmo_square, 0.0});
}

double distance_to(const SolidGizmo& gizmo, const GizmoView& view, const GizmoHandle& handle,
                   const Vec2d& p) {
    if (!can_be_held(gizmo, view, handle)) return HUGE_VAL;
    if (handle.part == GizmoPart::square) return distance_to_square(gizmo, view, p);
    if (handle.part == GizmoPart::ring) return distance_to_ring(gizmo, view, handle.axis, p);
    const Vec3d tip = arrow_tip(gizmo, handle.axis);
    return distance_to(p, seen(view, glm::mix(gizmo.centre, tip, grip)), seen(view, tip));
}

/// Returns where a ray meets the plane; empty where it does not, in front of its origin.
std::optional<Vec3d> meet(const Ray& ray, const Vec3d& point, const Vec3d& normal) {
    const double slope = glm::dot(ray.direction, normal);
    const double t = glm::dot(point - ray.origin, normal) / slope;
    if (!std::isfinite(t) || t <= ray.begin) return {};
    return ray.at(t);
}

/// Returns a pixel's position along an axis, on the plane through the axis that faces the eye most.
std::optional<double> along(const SolidGizmo& gizmo, const GizmoView& view, int axis,
                            const Vec2d& pixel) {
    const Vec3d& a = gizmo.axes[std::size_t(axis)];
    const Vec3d to_eye = view.camera.eye - gizmo.centre;
    const auto at = meet(ray_through(view.camera, view.size, pixel), gizmo.centre,
                         to_eye - glm::dot(to_eye, a) * a);
    if (!at) return {};
    return glm::dot(*at - gizmo.centre, a);
}

std::optional<double> angle_in_plane(const SolidGizmo& gizmo, const GizmoView& view,
                                     const Vec3d& axis, const Vec2d& from, const Vec2d& to) {
    const auto a = meet(ray_through(view.camera, view.size, from), gizmo.centre, axis),
               b = meet(ray_through(view.camera, view.size, to), gizmo.centre, axis);
    if (!a || !b) return {};
    const Vec3d u = *a - gizmo.centre, v = *b - gizmo.centre;
    return std::atan2(glm::dot(axis, glm::cross(u, v)), glm::dot(u, v));
}

/// Returns the angle of a ring seen edge on: the pointer's way along the ring's near half.
double angle_along_edge(const SolidGizmo& gizmo, const GizmoView& view, const Vec3d& axis,
                        const Vec2d& from, const Vec2d& to) {
    const Vec3d to_eye = view.camera.eye - gizmo.centre;
    const Vec3d nearest = glm::normalize(to_eye - glm::dot(to_eye, axis) * axis);
    const Vec3d ahead = gizmo_ring * gizmo.length * glm::cross(axis, nearest);
    const Vec2d per_radian = seen(view, gizmo.centre + ahead) - seen(view, gizmo.centre);
    return glm::dot(to - from, per_radian) / glm::dot(per_radian, per_radian);
}

std::optional<double> angle(const SolidGizmo& gizmo, const GizmoView& view, int axis,
                            const Vec2d& from, const Vec2d& to) {
    const Vec3d& a = gizmo.axes[std::size_t(axis)];
    const double facing = glm::dot(glm::normalize(view.camera.eye - gizmo.centre), a);
    if (std::abs(facing) < edge_on) return angle_along_edge(gizmo, view, a, from, to);
    return angle_in_plane(gizmo, view, a, from, to);
}

}  // namespace

SolidGizmo gizmo_of(const GizmoView& view, const SolidOptions& solid, const Vec3d& anchor,
                    double pixels) {
    const Mat3d turn = glm::transpose(rotation_about_axes(solid.rotate));
    const Vec3d at = turn * (anchor - solid.translate) / solid.scale;
    const double unit = view.solid_from_scene.linear[0][0];
    SolidGizmo gizmo;
    gizmo.centre = (at - view.solid_from_scene.offset) / unit;
    gizmo.axes = {turn[0], turn[1], turn[2]};
    const double depth = project(view.camera, view.size, gizmo.centre).z;
    gizmo.length = 2.0 * pixels * depth / (view.camera.focal_y * view.size.height);
    return gizmo;
}

Vec3d gizmo_anchor(const GizmoView& view, const SolidOptions& solid,
                   const std::optional<Vec3d>& anchor, const Sphere& sphere, const Vec3d& centre) {
    const auto inside = [&](const Vec3d& point) {
        const Vec3d at = gizmo_of(view, solid, point, 1.0).centre;
        return glm::distance(at, sphere.centre) <= sphere.radius;
    };
    if (anchor && inside(*anchor)) return *anchor;
    if (inside(Vec3d(0.0))) return Vec3d(0.0);
    const Mat3d turn = rotation_about_axes(solid.rotate);
    return solid.scale * (turn * view.solid_from_scene(centre)) + solid.translate;
}

std::vector<Vec3d> ring_points(const SolidGizmo& gizmo, int axis) {
    return circle(gizmo.centre, gizmo.axes[std::size_t(axis)], gizmo_ring * gizmo.length,
                  ring_sides);
}

Vec3d arrow_tip(const SolidGizmo& gizmo, int axis) {
    return gizmo.centre + gizmo.length * gizmo.axes[std::size_t(axis)];
}

bool can_be_held(const SolidGizmo& gizmo, const GizmoView& view, const GizmoHandle& handle) {
    if (!(project(view.camera, view.size, gizmo.centre).z > view.camera.near_distance))
        return false;
    return handle.part != GizmoPart::arrow ||
           glm::distance(seen(view, gizmo.centre), seen(view, arrow_tip(gizmo, handle.axis))) >
               end_on;
}

std::optional<GizmoHandle> handle_at(const SolidGizmo& gizmo, const GizmoView& view,
                                     const Vec2d& pixel) {
    std::optional<GizmoHandle> found;
    double nearest = gizmo_reach;
    for (const GizmoHandle& handle : gizmo_handles) {
        const double away = distance_to(gizmo, view, handle, pixel);
        if (away >= nearest) continue;
        if (handle.part == GizmoPart::square) return handle;
        found = handle;
        nearest = away;
    }
    return found;
}

std::optional<Vec2d> place_of(const SolidGizmo& gizmo, const GizmoView& view,
                              const GizmoHandle& handle) {
    std::vector<Vec3d> places{gizmo.centre};
    if (handle.part == GizmoPart::arrow)
        places = {glm::mix(gizmo.centre, arrow_tip(gizmo, handle.axis), 0.92)};
    if (handle.part == GizmoPart::ring) places = ring_points(gizmo, handle.axis);
    const auto depth = [&](const Vec3d& p) { return project(view.camera, view.size, p).z; };
    std::ranges::sort(places, std::less(), depth);
    for (const Vec3d& place : places)
        if (handle_at(gizmo, view, seen(view, place)) == handle) return seen(view, place);
    return {};
}

std::optional<SolidOptions> pulled(const SolidOptions& start, const SolidGizmo& gizmo,
                                   const GizmoView& view, const GizmoHandle& handle,
                                   const Vec2d& from, const Vec2d& to) {
    if (from == to) return start;
    const Vec3d pivot = view.solid_from_scene(gizmo.centre);
    const Vec3d& axis = gizmo.axes[std::size_t(handle.axis)];
    if (handle.part == GizmoPart::square)
        return enlarged(start, pivot, std::exp2((to.x - from.x + from.y - to.y) / doubling));
    if (handle.part == GizmoPart::ring) {
        const auto by = angle(gizmo, view, handle.axis, from, to);
        if (!by) return {};
        return turned(start, pivot, turn_about(axis, *by));
    }
    const auto before = along(gizmo, view, handle.axis, from),
               now = along(gizmo, view, handle.axis, to);
    if (!before || !now) return {};
    return moved(start, view.solid_from_scene.linear * ((*now - *before) * axis));
}

}  // namespace burl
