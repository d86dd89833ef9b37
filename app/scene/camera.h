#pragma once
// The orbit camera both renderers share, all in double, so that a GL picture and a ground-truth
// picture of the same scene line up to the pixel (docs/reference/rendering.md).
#include <algorithm>
#include <limits>
#include <string>

#include "atlas/base/vec.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Where to look from: a point on a sphere around the scene's bounding sphere.
struct View {
    double azimuth_degrees = 30.0;    ///< 0: camera on +z, 90: on +x (y is up, as in glTF)
    double elevation_degrees = 20.0;  ///< [-90, 90], positive: from above
    double distance = 3.5;            ///< eye to centre, in bounding-sphere radii, > 0
    bool operator==(const View&) const = default;
};

/// Picture size in pixels.
struct PictureSize {
    int width = 1024;
    int height = 768;
    bool operator==(const PictureSize&) const = default;
};

inline constexpr int max_picture_side = 16384;
inline constexpr double vertical_field_of_view_degrees = 35.0;

/// "az,el,dist", for example "30,20,3.5". Throws Error(usage).
View parse_view(const std::string& text);

/// "WIDTHxHEIGHT", each 1..16384, for example "1024x768". Throws Error(usage).
PictureSize parse_picture_size(const std::string& text);

struct Sphere {
    Vec3d centre{0.0};
    double radius = 0.0;
};

/// Sphere around the centre of the box of the points that `for_each_point(visit)` hands to
/// `visit(const Vec3d&)`; it is walked twice.
template <class ForEachPoint>
Sphere sphere_around(ForEachPoint for_each_point) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box3 box{Vec3d(infinity), Vec3d(-infinity)};
    for_each_point([&](const Vec3d& p) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    });
    if (!(box.low.x <= box.high.x)) return {};
    Sphere sphere{box.centre(), 0.0};
    for_each_point([&](const Vec3d& p) {
        sphere.radius = std::max(sphere.radius, glm::distance(p, sphere.centre));
    });
    return sphere;
}

/// Over all triangles' points, every instance included.
Sphere bounding_sphere(const Mesh& mesh);

/// A pinhole camera in scene space. Clip space and depth range are those of OpenGL (-w..w).
struct Camera {
    Vec3d eye{0.0};
    Vec3d right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, back{0.0, 0.0, 1.0};  ///< orthonormal
    double focal_x = 1.0, focal_y = 1.0;  ///< cotangents of half the fields of view
    double near_distance = 0.1, far_distance = 10.0;

    /// Scene to eye space (camera at the origin looking along -z), both in scene units.
    Mat4d eye_from_scene() const;
    Mat4d clip_from_eye() const;
};

/// The camera that `view` puts around `sphere`; a sphere of radius 0 counts as radius 1.
Camera orbit_camera(const View& view, const Sphere& sphere, const PictureSize& size);

/// Pixel coordinates (x to the right, y down, pixel (0,0)'s centre at (0.5,0.5)) and the distance
/// along the view axis in z; meaningful only where z > 0.
Vec3d project(const Camera& camera, const PictureSize& size, const Vec3d& scene_point);

}  // namespace burl
