#include "app/scene/ray.h"

namespace burl {

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
