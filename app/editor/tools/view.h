#pragma once
// The object's view as tools on the surface see it: what is shown, where on the screen, and what
// lies under a pointer.
#include <memory>
#include <optional>

#include "app/editor/tools/camera.h"
#include "app/scene/surface_pick.h"

namespace burl {

/// What the object's view shows and where. Places on the screen are those of the pointer, y down.
struct ObjectView {
    std::shared_ptr<const SurfacePick> pick{};  ///< null: nothing can be touched yet
    double share = 0.0;                         ///< of the way to its pose
    Affine3 solid_from_mesh{};
    Affine3 unit_from_mesh{};  ///< solid_from_mesh of SolidSpace::unit
    EditCamera camera{};
    Sphere sphere{};
    Vec2d low{0.0}, size{0.0};  ///< on the screen
};

/// Of the view in whole screen units.
PictureSize picture_size(const ObjectView& view);
Camera camera_of(const ObjectView& view);

/// Through a place on the screen.
Ray ray_at(const ObjectView& view, const Vec2d& pointer);

/// What the object shows there; empty beside it.
std::optional<SurfaceHit> hit_at(const ObjectView& view, const Vec2d& pointer);

/// Where a point of the scene is on the screen, and its distance along the view axis in z.
Vec3d on_screen(const ObjectView& view, const Vec3d& point);

bool is_over(const ObjectView& view, const Vec2d& pointer);

}  // namespace burl
