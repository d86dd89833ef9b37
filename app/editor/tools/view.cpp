#include "app/editor/tools/view.h"

namespace burl {

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
