#pragma once
// The editor's camera: an orbit about a movable target.
#include "app/scene/camera.h"

namespace burl {

/// An orbiting view, as `burl render --view` takes it, and the target it looks at.
struct EditCamera {
    View view{};
    /// Offset of the target from the centre of the scene's bounding sphere, in its radii.
    Vec3d target{0.0};
    bool operator==(const EditCamera&) const = default;
};

/// Returns the camera turned by dragging the scene by `pixels`; `side`, the picture's shorter side
/// in pixels, is half a turn. The elevation is clamped to -90 to 90 degrees.
EditCamera orbited(EditCamera camera, const glm::dvec2& pixels, double side);

/// Returns the camera moved sideways so that points at the target's depth follow the pointer.
EditCamera panned(EditCamera camera, const glm::dvec2& pixels, double side);

/// Returns the camera nearer by a tenth per notch, its distance clamped to 0.05 to 100 radii.
EditCamera zoomed(EditCamera camera, double notches);

/// Returns the camera with the whole scene in view again, from the same direction.
EditCamera fitted(EditCamera camera);

/// Return the camera looking straight from the front, the right side or the top.
EditCamera from_front(EditCamera camera);
EditCamera from_side(EditCamera camera);
EditCamera from_top(EditCamera camera);

/// Returns the camera for rendering; the field of view is that of the picture's shorter side.
Camera camera_of(const EditCamera& camera, const Sphere& sphere, const PictureSize& size);

/// Returns the ray through a point of the picture, in pixels from its upper left corner.
Ray ray_of(const EditCamera& camera, const Sphere& sphere, const PictureSize& size,
           const Vec2d& pixel);

}  // namespace burl
