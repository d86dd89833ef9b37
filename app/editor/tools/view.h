#pragma once
// The object's view as the tools on the surface see it: what is shown, its rectangle on the screen,
// and picking.
#include <memory>
#include <optional>

#include "app/editor/tools/camera.h"
#include "app/scene/surface_pick.h"

namespace burl {

/// The content and the rectangle of the object's view. Screen positions are the pointer's, y down.
struct ObjectView {
    std::shared_ptr<const SurfacePick> pick{};  ///< picking structure; null: not ready
    double share = 0.0;                         ///< share of the way to the pose, 0 to 1
    Affine3 solid_from_mesh{};
    Affine3 unit_from_mesh{};  ///< solid_from_mesh of SolidSpace::unit
    EditCamera camera{};
    Sphere sphere{};
    Vec2d low{0.0}, size{0.0};  ///< upper left corner and size of the rectangle on the screen
};

/// The view's size in whole screen units.
PictureSize picture_size(const ObjectView& view);
Camera camera_of(const ObjectView& view);

/// The ray through a position on the screen.
Ray ray_at(const ObjectView& view, const Vec2d& pointer);

/// The surface point under the pointer; empty beside the object.
std::optional<SurfaceHit> hit_at(const ObjectView& view, const Vec2d& pointer);

/// A scene point's position on the screen (x, y) and its distance along the view axis (z).
Vec3d on_screen(const ObjectView& view, const Vec3d& point);

/// Whether the pointer is over the view.
bool is_over(const ObjectView& view, const Vec2d& pointer);

}  // namespace burl
