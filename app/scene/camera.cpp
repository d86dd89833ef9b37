#include "app/scene/camera.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "atlas/base/error.h"

namespace burl {

namespace {

double radians(double degrees) {
    return degrees * (std::numbers::pi / 180.0);
}

template <class T>
std::optional<std::vector<T>> parse_numbers(const std::string& text, char separator) {
    std::vector<T> numbers;
    const char* begin = text.data();
    const char* const end = begin + text.size();
    while (true) {
        T value{};
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error != std::errc()) return std::nullopt;
        numbers.push_back(value);
        if (stop == end) return numbers;
        if (*stop != separator) return std::nullopt;
        begin = stop + 1;
    }
}

}  // namespace

View parse_view(const std::string& text) {
    const auto numbers = parse_numbers<double>(text, ',');
    const bool finite = numbers && std::all_of(numbers->begin(), numbers->end(),
                                               [](double x) { return std::isfinite(x); });
    if (!finite || numbers->size() != 3) {
        throw Error(ExitCode::usage,
                    fmt::format("'{}' is not a view; write azimuth,elevation,distance, for example "
                                "30,20,3.5",
                                text));
    }
    const View view{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    if (std::abs(view.elevation_degrees) > 90.0) {
        throw Error(ExitCode::usage,
                    fmt::format("the view '{}' has elevation {}; it must lie between -90 and 90",
                                text, view.elevation_degrees));
    }
    if (!(view.distance > 0.0)) {
        throw Error(ExitCode::usage, fmt::format("the view '{}' has distance {}; it must be "
                                                 "above 0 (in bounding-sphere radii)",
                                                 text, view.distance));
    }
    return view;
}

PictureSize parse_picture_size(const std::string& text) {
    const auto numbers = parse_numbers<int>(text, 'x');
    const auto fits = [](int side) { return side >= 1 && side <= max_picture_side; };
    if (!numbers || numbers->size() != 2 || !fits((*numbers)[0]) || !fits((*numbers)[1])) {
        throw Error(ExitCode::usage, fmt::format("'{}' is not a picture size; write WIDTHxHEIGHT "
                                                 "with sides from 1 to {}, for example 1024x768",
                                                 text, max_picture_side));
    }
    return {(*numbers)[0], (*numbers)[1]};
}

Sphere bounding_sphere(const Mesh& mesh) {
    return sphere_around([&](auto visit) {
        for (const Part& part : mesh.parts) {
            for (const Mat4d& placement : part.instances) {
                for (std::uint32_t t = 0; t < part.triangle_count; ++t) {
                    for (const std::uint32_t corner : mesh.triangles[part.first_triangle + t]) {
                        visit(Vec3d(placement * Vec4d(mesh.positions[corner], 1.0)));
                    }
                }
            }
        }
    });
}

Camera orbit_camera(const View& view, const Sphere& sphere, const PictureSize& size) {
    const double azimuth = radians(view.azimuth_degrees);
    const double elevation = radians(view.elevation_degrees);
    const double radius = sphere.radius > 0.0 ? sphere.radius : 1.0;
    const double distance = view.distance * radius;

    Camera camera;
    camera.right = {std::cos(azimuth), 0.0, -std::sin(azimuth)};
    camera.back = {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                   std::cos(azimuth) * std::cos(elevation)};
    camera.up = glm::cross(camera.back, camera.right);
    camera.eye = sphere.centre + distance * camera.back;
    camera.focal_y = 1.0 / std::tan(radians(0.5 * vertical_field_of_view_degrees));
    camera.focal_x = camera.focal_y * double(size.height) / double(size.width);
    // The near and far planes leave 1 % of the radius; inside the sphere the near plane stays at 1
    // % of its radius.
    camera.near_distance = std::max(distance - 1.01 * radius, 0.01 * radius);
    camera.far_distance = distance + 1.01 * radius;
    return camera;
}

Mat4d Camera::eye_from_scene() const {
    const Mat3d rotation = glm::transpose(Mat3d(right, up, back));
    Mat4d result(rotation);
    result[3] = Vec4d(-(rotation * eye), 1.0);
    return result;
}

Mat4d Camera::clip_from_eye() const {
    const double n = near_distance, f = far_distance;
    Mat4d result(0.0);
    result[0][0] = focal_x;
    result[1][1] = focal_y;
    result[2][2] = (f + n) / (n - f);
    result[2][3] = -1.0;
    result[3][2] = 2.0 * f * n / (n - f);
    return result;
}

Vec3d project(const Camera& camera, const PictureSize& size, const Vec3d& scene_point) {
    const Vec3d d = scene_point - camera.eye;
    const double depth = -glm::dot(d, camera.back);
    const double x = camera.focal_x * glm::dot(d, camera.right) / depth;
    const double y = camera.focal_y * glm::dot(d, camera.up) / depth;
    return {0.5 * size.width * (1.0 + x), 0.5 * size.height * (1.0 - y), depth};
}

Ray ray_through(const Camera& camera, const PictureSize& size, const Vec2d& pixel) {
    const double x = (2.0 * pixel.x / size.width - 1.0) / camera.focal_x;
    const double y = (1.0 - 2.0 * pixel.y / size.height) / camera.focal_y;
    Ray ray;
    ray.origin = camera.eye;
    ray.direction = x * camera.right + y * camera.up - camera.back;
    ray.begin = camera.near_distance;
    return ray;
}

}  // namespace burl
