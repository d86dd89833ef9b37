#pragma once
// The editor's camera: an orbit about a point that can be moved, as hands expect it.
#include "app/scene/ray.h"

namespace burl {

/// The view that `burl render --view` takes, and where it looks besides the scene's centre.
struct EditCamera {
    View view{};
    Vec3d target{0.0};  ///< offset of what is looked at from the sphere's centre, in its radii
    bool operator==(const EditCamera&) const = default;
};

/// Turned as by dragging the scene by so many pixels of a picture whose shorter side is `side`
/// pixels long: that is half a turn. Elevation stays within straight up and down.
EditCamera orbited(EditCamera camera, const glm::dvec2& pixels, double side);

/// Moved so that what is at the target's depth follows the pointer.
EditCamera panned(EditCamera camera, const glm::dvec2& pixels, double side);

/// Nearer by a tenth per notch, between 0.05 and 100 radii.
EditCamera zoomed(EditCamera camera, double notches);

/// The whole scene again, from the same side.
EditCamera fitted(EditCamera camera);

/// Straight from the front, the right side or the top.
EditCamera from_front(EditCamera camera);
EditCamera from_side(EditCamera camera);
EditCamera from_top(EditCamera camera);

/// Its field of view is that of the picture's shorter side.
Camera camera_of(const EditCamera& camera, const Sphere& sphere, const PictureSize& size);

/// Through a point of the picture, in its pixels, from its left upper corner.
Ray ray_of(const EditCamera& camera, const Sphere& sphere, const PictureSize& size,
           const Vec2d& pixel);

}  // namespace burl
