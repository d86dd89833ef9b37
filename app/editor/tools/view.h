#pragma once
// The editor's camera, an orbit about a movable target, and the object's view as the tools on the
// surface see it: what is shown, its rectangle on the screen, and picking.
#include <memory>
#include <optional>

#include "app/scene/camera.h"
#include "app/scene/surface_pick.h"

namespace burl {

/// The scene's axis that is up on the screen.
enum class UpAxis { y, z, minus_z };

/// An orbiting view, as `burl render --view` takes it, and the target it looks at.
struct EditCamera {
    View view{};
    /// Offset of the target from the centre of the scene's bounding sphere, in its radii.
    Vec3d target{0.0};
    UpAxis up = UpAxis::y;
    bool operator==(const EditCamera&) const = default;
};

/// Returns the camera turned by dragging the scene by `pixels`; `side`, the picture's shorter side
/// in pixels, is half a turn. The elevation is clamped to -90 to 90 degrees.
EditCamera orbited(EditCamera camera, const glm::dvec2& pixels, double side);

/// Returns the camera moved sideways so that points at the target's depth follow the pointer.
EditCamera panned(EditCamera camera, const glm::dvec2& pixels, double side);

/// Returns the camera nearer by a tenth per notch, its distance clamped to 0.05 to 100 radii. The
/// point at the target's depth that is seen `pixels` from the view's middle (y down) stays there.
EditCamera zoomed(EditCamera camera, double notches, const glm::dvec2& pixels = {0.0, 0.0},
                  double side = 1.0);

/// Returns the camera with the whole scene in view again, from the same direction.
EditCamera fitted(EditCamera camera);

/// Return the camera looking straight from the front, the right side or the top.
EditCamera from_front(EditCamera camera);
EditCamera from_side(EditCamera camera);
EditCamera from_top(EditCamera camera);

/// The rotation of the scene that brings its up axis to +y: by a quarter about x for z and -z, so
/// that +x stays to the right.
Mat3d upright(UpAxis up);

/// Returns the camera for rendering; the field of view is that of the picture's shorter side.
Camera camera_of(const EditCamera& camera, const Sphere& sphere, const PictureSize& size);

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
