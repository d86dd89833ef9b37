#pragma once
// Rays through a picture's pixels, the inverse of the camera's projection.
#include <limits>

#include "app/scene/camera.h"

namespace burl {

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
