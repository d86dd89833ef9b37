#pragma once
// Taking hold of the texture on the object's view: a press on the surface or on a handle of the
// gizmo, and what the pointer's way from there makes of the recipe's transform. Knows no user
// interface.
#include <optional>

#include "app/editor/tools/solid_drag.h"
#include "app/editor/tools/solid_gizmo.h"
#include "app/editor/tools/view.h"

namespace burl {

/// What a press has taken hold of.
class SolidGrab {
  public:
    /// A point of the surface; empty beside the object.
    static std::optional<SolidGrab> surface(const ObjectView& view, const SolidOptions& start,
                                            SolidDrag drag, const Vec2d& pointer);
    static SolidGrab handle(const SolidGizmo& gizmo, const GizmoHandle& handle,
                            const SolidOptions& start, const Vec2d& pointer);

    const SolidOptions& start() const { return start_; }
    /// Of the gizmo; empty: the surface was taken.
    const std::optional<GizmoHandle>& handle() const { return handle_; }
    /// Of the surface.
    SolidDrag drag() const { return drag_; }

    /// The transform with the pointer there. Beside the object it goes on over the plane parallel
    /// to the picture through where it was on the surface last. Empty where it says nothing.
    std::optional<SolidOptions> to(const ObjectView& view, const Vec2d& pointer);

    /// Where in the scene what was taken is held now.
    const Vec3d& held() const { return held_; }

  private:
    SolidGrab() = default;
    Vec3d solid_point(const ObjectView& view, const Vec2d& pointer);

    SolidOptions start_{};
    SolidDrag drag_ = SolidDrag::move;
    Vec3d from_{0.0};  ///< in the solid
    Vec3d held_{0.0};
    Vec3d rest_offset_{0.0};      ///< from where the place hit last is to where it is at rest
    Mat4d mesh_from_scene_{1.0};  ///< of the placement that is held
    std::optional<GizmoHandle> handle_{};
    SolidGizmo gizmo_{};
    Vec2d pressed_{0.0};
};

/// A step by a key: solid_drag.h's, by a fiftieth of the object's radius, about its middle.
SolidOptions stepped(const ObjectView& view, const SolidOptions& start, SolidDrag drag,
                     const Vec2d& way);

/// The middle of the object's box, about which the texture is turned and sized, in the scene.
Vec3d middle_of(const ObjectView& view);

/// The view as the gizmo wants it, whose pixels are pointers less view.low.
GizmoView gizmo_view(const ObjectView& view);

}  // namespace burl
