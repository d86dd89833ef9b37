#pragma once
// The orbit camera of both renderers and rays through its pictures, all in float64, so that an
// OpenGL picture and a ground-truth picture of one scene agree to the pixel
// (docs/reference/rendering.md).
#include <algorithm>
#include <limits>
#include <string>

#include "atlas/base/vec.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A viewpoint on a sphere around the scene's bounding sphere.
struct View {
    double azimuth_degrees = 30.0;    ///< 0: camera on +z, 90: on +x (y is up, as in glTF)
    double elevation_degrees = 20.0;  ///< [-90, 90]; positive views from above
    double distance = 3.5;            ///< the eye's distance from the centre in radii, > 0
    bool operator==(const View&) const = default;
};

/// The size of a picture in pixels.
struct PictureSize {
    int width = 1024;
    int height = 768;
    bool operator==(const PictureSize&) const = default;
};

inline constexpr int max_picture_side = 16384;
inline constexpr double vertical_field_of_view_degrees = 35.0;

/// Parses "az,el,dist" (degrees, degrees, radii), for example "30,20,3.5". Throws Error(usage).
View parse_view(const std::string& text);

/// Parses "WIDTHxHEIGHT", each 1..16384, for example "1024x768". Throws Error(usage).
PictureSize parse_picture_size(const std::string& text);

struct Sphere {
    Vec3d centre{0.0};
    double radius = 0.0;
};

/// A bounding sphere around the centre of the points' bounding box. `for_each_point(visit)` passes
/// each point to `visit(const Vec3d&)`; it is called twice.
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

/// The bounding sphere of all triangles' points, every instance included.
Sphere bounding_sphere(const Mesh& mesh);

/// A pinhole camera in scene space. Clip space and depth range are those of OpenGL (-w..w).
struct Camera {
    Vec3d eye{0.0};
    Vec3d right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, back{0.0, 0.0, 1.0};  ///< an orthonormal basis
    double focal_x = 1.0, focal_y = 1.0;  ///< cotangents of half the fields of view
    double near_distance = 0.1, far_distance = 10.0;

    /// The map from scene to eye space (camera at the origin looking along -z), both in scene
    /// units.
    Mat4d eye_from_scene() const;
    Mat4d clip_from_eye() const;
};

/// The camera at `view` around `sphere`; a sphere of radius 0 counts as radius 1.
Camera orbit_camera(const View& view, const Sphere& sphere, const PictureSize& size);

/// The pixel coordinates of a point (x to the right, y down, pixel (0,0)'s centre at (0.5,0.5))
/// and, in z, its distance along the view axis; meaningful only where z > 0.
Vec3d project(const Camera& camera, const PictureSize& size, const Vec3d& scene_point);

/// The points origin + t * direction with t in [begin, end]. The direction has any length but 0.
struct Ray {
    Vec3d origin{0.0}, direction{0.0, 0.0, -1.0};
    double begin = 0.0, end = std::numeric_limits<double>::infinity();
    Vec3d at(double t) const { return origin + t * direction; }
};

/// The ray through a point of the picture, in pixels (x to the right, y down, pixel (0,0)'s centre
/// at (0.5,0.5)): the inverse of project(). t is the distance along the view axis; the ray begins
/// at the near plane.
Ray ray_through(const Camera& camera, const PictureSize& size, const Vec2d& pixel);

}  // namespace burl
