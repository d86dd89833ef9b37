#pragma once
// Dragging the texture in the object's view: a press on the surface or on a handle of the gizmo,
// and the recipe's transform for every later pointer position. Independent of the user interface.
#include <optional>

#include "app/editor/tools/solid_drag.h"
#include "app/editor/tools/solid_gizmo.h"
#include "app/editor/tools/view.h"

namespace burl {

/// A grip on the texture from press to release.
class SolidGrab {
  public:
    /// Grips the surface under the pointer; empty where the pointer is beside the object.
    static std::optional<SolidGrab> surface(const ObjectView& view, const SolidOptions& start,
                                            SolidDrag drag, const Vec2d& pointer);
    /// Grips a handle of the gizmo.
    static SolidGrab handle(const SolidGizmo& gizmo, const GizmoHandle& handle,
                            const SolidOptions& start, const Vec2d& pointer);

    const SolidOptions& start() const { return start_; }
    /// The gizmo's handle that is gripped; empty: the surface is.
    const std::optional<GizmoHandle>& handle() const { return handle_; }
    /// The effect of a drag on the surface; meaningless for a handle.
    SolidDrag drag() const { return drag_; }

    /// Returns the transform for a pointer position. Beside the object a drag goes on over the
    /// plane parallel to the picture through the last point on the surface. Empty where a handle's
    /// transform is undefined there (pulled()).
    std::optional<SolidOptions> to(const ObjectView& view, const Vec2d& pointer);

    /// The gripped point in the scene, now.
    const Vec3d& held() const { return held_; }

  private:
    SolidGrab() = default;
    Vec3d solid_point(const ObjectView& view, const Vec2d& pointer);

    SolidOptions start_{};
    SolidDrag drag_ = SolidDrag::move;
    Vec3d from_{0.0};  ///< solid point pressed
    Vec3d held_{0.0};
    /// Vector from the last hit, posed, to its place at rest, in the mesh's space.
    Vec3d rest_offset_{0.0};
    Mat4d mesh_from_scene_{1.0};  ///< inverse of the gripped placement's matrix
    std::optional<GizmoHandle> handle_{};
    SolidGizmo gizmo_{};
    Vec2d pressed_{0.0};  ///< pointer position of the press
};

/// Returns the transform after a key step: a move by 1/50 of the object's radius, or a turn or
/// scaling about the object's middle (stepped() of solid_drag.h).
SolidOptions stepped(const ObjectView& view, const SolidOptions& start, SolidDrag drag,
                     const Vec2d& way);

/// The centre of the object's bounding box in the scene: the pivot of turns and scalings.
Vec3d middle_of(const ObjectView& view);

/// Returns the gizmo's view; its pixels are pointer positions minus view.low.
GizmoView gizmo_view(const ObjectView& view);

}  // namespace burl
