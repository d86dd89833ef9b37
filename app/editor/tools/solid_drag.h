#pragma once
// Dragging a texture on its object: from a gripped solid point and its new position to the recipe's
// transform, the direct manipulation that "Antialiased Parameterized Solid Texturing" (1999) leaves
// to the future. Points are those of solid space before the recipe's transform; results have ten
// significant digits, so that recipes stay readable.
#include "app/recipe/recipe.h"
#include "app/scene/camera.h"

namespace burl {

/// Returns the transform that shows the texture moved: what was at x is at x + offset.
SolidOptions moved(SolidOptions solid, const Vec3d& offset);

/// Returns the transform that shows the texture turned: what was at pivot + d is at pivot + turn *
/// d. `turn` must be a rotation.
SolidOptions turned(SolidOptions solid, const Vec3d& pivot, const Mat3d& turn);

/// Returns the transform that shows the texture enlarged: what was at pivot + d is at pivot +
/// factor * d. factor > 0; solid.scale is clamped to 1e-6 to 1e6.
SolidOptions enlarged(SolidOptions solid, const Vec3d& pivot, double factor);

/// The effect of a drag on the texture.
enum class SolidDrag {
    move,  ///< what was at `from` is at `to`
    turn,  ///< the direction from the pivot to `from` becomes that to `to`
    size   ///< enlarges by the ratio of the distances of `to` and `from` from the pivot
};

/// The pivot of turns and scalings. A hand cannot aim close to it: points within `reach` are lifted
/// towards the viewer onto a sphere of that radius, as on a trackball, for directions, and
/// distances are at least `reach`.
struct DragPivot {
    Vec3d point{0.0};
    double reach = 0.0;
    Vec3d viewer{0.0, 0.0, 1.0};  ///< unit vector towards the viewer
};

/// Returns the transform after a drag from `from` to `to`; `start` where they are equal.
SolidOptions dragged(const SolidOptions& start, SolidDrag drag, const DragPivot& pivot,
                     const Vec3d& from, const Vec3d& to);

/// Returns the transform after a key step in the direction `way`, (1, 0) being right and (0, 1) up
/// in the picture: a move by `distance` solid units, a turn about the pivot by 5 degrees as a
/// rolling ball turns, or an enlargement by 5 % for right and up.
SolidOptions stepped(const SolidOptions& start, SolidDrag drag, const Camera& camera,
                     const Vec3d& pivot, const Vec2d& way, double distance);

/// Returns the point where a ray of ray_through() meets the plane parallel to the picture through
/// `through`: the point dragged while the pointer is beside the object.
Vec3d beside(const Camera& camera, const Ray& ray, const Vec3d& through);

}  // namespace burl
