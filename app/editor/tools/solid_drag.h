#pragma once
// Dragging a texture on its object: from a point of the solid that was taken hold of and the place
// it should have to the recipe's transform, the direct manipulation that "Antialiased Parameterized
// Solid Texturing" (1999) leaves to the future. Points are those of solid space before the scale;
// results have ten significant digits, so that recipes stay readable.
#include "app/recipe/recipe.h"
#include "app/scene/ray.h"

namespace burl {

/// The texture carried along: what was at x is at x + offset.
SolidOptions moved(SolidOptions solid, const Vec3d& offset);

/// Turned about a point: what was at pivot + d is at pivot + turn * d. `turn` is a rotation.
SolidOptions turned(SolidOptions solid, const Vec3d& pivot, const Mat3d& turn);

/// Larger about a point: what was at pivot + d is at pivot + factor * d, as far as solid.scale goes
/// (1e-6 to 1e6). factor > 0.
SolidOptions enlarged(SolidOptions solid, const Vec3d& pivot, double factor);

/// What a drag does to the texture.
enum class SolidDrag {
    move,  ///< what was at `from` is at `to`
    turn,  ///< what was in the direction of `from`, seen from the pivot, is in that of `to`
    size   ///< larger as `to` is farther from the pivot than `from`
};

/// About what a drag turns and sizes. Within `reach` of it a hand cannot aim: there directions are
/// those of points that bulge towards the viewer, as on a trackball, and distances count as
/// `reach`.
struct DragPivot {
    Vec3d point{0.0};
    double reach = 0.0;
    Vec3d viewer{0.0, 0.0, 1.0};  ///< direction to the viewer, of length 1
};

/// `start` where `from` is `to`.
SolidOptions dragged(const SolidOptions& start, SolidDrag drag, const DragPivot& pivot,
                     const Vec3d& from, const Vec3d& to);

/// A step by a key in the picture, one to the right or up being (1, 0) or (0, 1): moves by
/// `distance` solid units, turns about the pivot by 5 degrees as a ball that is rolled, or makes
/// larger by 5 % to the right or up.
SolidOptions stepped(const SolidOptions& start, SolidDrag drag, const Camera& camera,
                     const Vec3d& pivot, const Vec2d& way, double distance);

/// Where a ray of ray_through() meets the plane parallel to the picture through a point: what a
/// pointer beside the object is at.
Vec3d beside(const Camera& camera, const Ray& ray, const Vec3d& through);

}  // namespace burl
