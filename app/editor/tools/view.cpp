#include "app/editor/tools/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burl {

namespace {

EditCamera turned_to(EditCamera camera, double azimuth, double elevation) {
    camera.view.azimuth_degrees = azimuth;
    camera.view.elevation_degrees = elevation;
    return camera;
}

/// Returns an orbit's camera, which sees the scene upright, as it stands in the scene itself.
Camera in_scene(Camera camera, UpAxis up, const Vec3d& centre) {
    const Mat3d back = glm::transpose(upright(up));
    camera.eye = centre + back * (camera.eye - centre);
    camera.right = back * camera.right;
    camera.up = back * camera.up;
    camera.back = back * camera.back;
    return camera;
}

/// The radii of the scene that a pixel is wide at the target's depth.
double radii_per_pixel(const EditCamera& camera, double side) {
    const double half_field = 0.5 * vertical_field_of_view_degrees * std::numbers::pi / 180.0;
    return 2.0 * camera.view.distance * std::tan(half_field) / std::max(side, 1.0);
}

}  // namespace

Mat3d upright(UpAxis up) {
    if (up == UpAxis::y) return Mat3d(1.0);
    const double s = up == UpAxis::z ? 1.0 : -1.0;
    // The rows say which of the scene's axes become x, y and z.
    return glm::transpose(Mat3d(Vec3d(1.0, 0.0, 0.0), Vec3d(0.0, 0.0, s), Vec3d(0.0, -s, 0.0)));
}

EditCamera orbited(EditCamera camera, const glm::dvec2& pixels, double side) {
    const double degrees = 180.0 / std::max(side, 1.0);
    const double azimuth = camera.view.azimuth_degrees - degrees * pixels.x;
    camera.view.azimuth_degrees = azimuth - 360.0 * std::floor(azimuth / 360.0 + 0.5);
    camera.view.elevation_degrees =
        std::clamp(camera.view.elevation_degrees + degrees * pixels.y, -90.0, 90.0);
    return camera;
}

EditCamera panned(EditCamera camera, const glm::dvec2& pixels, double side) {
    const Camera looking =
        in_scene(orbit_camera(camera.view, {Vec3d(0.0), 1.0}, {1, 1}), camera.up, Vec3d(0.0));
    camera.target +=
        radii_per_pixel(camera, side) * (pixels.y * looking.up - pixels.x * looking.right);
    return camera;
}

EditCamera zoomed(EditCamera camera, double notches, const glm::dvec2& pixels, double side) {
    const double before = camera.view.distance;
    const double after = std::clamp(before * std::pow(0.9, notches), 0.05, 100.0);
    camera = panned(camera, -(1.0 - after / before) * pixels, side);
    camera.view.distance = after;
    return camera;
}

EditCamera fitted(EditCamera camera) {
    camera.target = Vec3d(0.0);
    camera.view.distance = View{}.distance;
    return camera;
}

EditCamera from_front(EditCamera camera) {
    return turned_to(camera, 0.0, 0.0);
}
EditCamera from_side(EditCamera camera) {
    return turned_to(camera, 90.0, 0.0);
}
EditCamera from_top(EditCamera camera) {
    return turned_to(camera, 0.0, 90.0);
}

Camera camera_of(const EditCamera& camera, const Sphere& sphere, const PictureSize& size) {
    const double radius = sphere.radius > 0.0 ? sphere.radius : 1.0;
    Camera result = in_scene(orbit_camera(camera.view, sphere, size), camera.up, sphere.centre);
    result.eye += radius * camera.target;
    // The field of view applies to the shorter side, so that the scene fits into narrow views, too.
    const double narrow = std::min(1.0, double(size.width) / std::max(size.height, 1));
    result.focal_x *= narrow;
    result.focal_y *= narrow;
    // With a moved target the bounding sphere is off centre: both clip planes make room for it.
    const double away = radius * glm::length(camera.target);
    const double distance = camera.view.distance * radius;
    result.near_distance =
        std::max(distance - away - 1.01 * radius, 0.01 * std::min(radius, distance));
    result.far_distance = distance + away + 1.01 * radius;
    return result;
}

PictureSize picture_size(const ObjectView& view) {
    return {int(view.size.x), int(view.size.y)};
}

Camera camera_of(const ObjectView& view) {
    return camera_of(view.camera, view.sphere, picture_size(view));
}

Ray ray_at(const ObjectView& view, const Vec2d& pointer) {
    return ray_through(camera_of(view), picture_size(view), pointer - view.low);
}

std::optional<SurfaceHit> hit_at(const ObjectView& view, const Vec2d& pointer) {
    if (!view.pick) return {};
    return view.pick->meet(ray_at(view, pointer));
}

Vec3d on_screen(const ObjectView& view, const Vec3d& point) {
    return project(camera_of(view), picture_size(view), point) + Vec3d(view.low, 0.0);
}

bool is_over(const ObjectView& view, const Vec2d& pointer) {
    const Vec2d within = pointer - view.low;
    return within.x >= 0.0 && within.y >= 0.0 && within.x < view.size.x && within.y < view.size.y;
}

}  // namespace burl
