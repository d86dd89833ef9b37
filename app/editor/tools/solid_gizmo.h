#pragma once
// The transform gizmo of a texture, drawn over the object: arrows along its axes that move the
// texture, rings about them that turn it, and a square in the middle that scales it. Its size on
// screen is constant. Independent of the user interface.
#include <array>
#include <optional>
#include <vector>

#include "app/recipe/recipe.h"
#include "app/scene/camera.h"

namespace burl {

/// The view that the gizmo is drawn into.
struct GizmoView {
    Camera camera{};
    PictureSize size{};
    Affine3 solid_from_scene{};  ///< a uniform scale and a translation
};

/// A gizmo's place in the scene.
struct SolidGizmo {
    Vec3d centre{0.0};  ///< position in the scene
    /// The texture's axes s, t and r, unit vectors in the scene.
    std::array<Vec3d, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    double length = 1.0;  ///< length of an arrow in the scene
};

inline constexpr double gizmo_ring = 0.75;  ///< radius of the rings, in lengths of an arrow
/// Largest distance of the pointer from a handle, in pixels.
inline constexpr double gizmo_reach = 7.0;
inline constexpr double gizmo_square = 8.0;  ///< half the side of the square, in pixels

enum class GizmoPart { arrow, ring, square };

struct GizmoHandle {
    GizmoPart part = GizmoPart::square;
    int axis = 0;  ///< 0 to 2 for arrows and rings
    bool operator==(const GizmoHandle&) const = default;
};

/// All handles: the square, then the arrows, then the rings.
inline constexpr std::array<GizmoHandle, 7> gizmo_handles{{{GizmoPart::square, 0},
                                                           {GizmoPart::arrow, 0},
                                                           {GizmoPart::arrow, 1},
                                                           {GizmoPart::arrow, 2},
                                                           {GizmoPart::ring, 0},
                                                           {GizmoPart::ring, 1},
                                                           {GizmoPart::ring, 2}}};

/// Returns the gizmo at the texture's point `anchor` (texture coordinates); an arrow seen from the
/// side is `pixels` long.
SolidGizmo gizmo_of(const GizmoView& view, const SolidOptions& solid, const Vec3d& anchor,
                    double pixels);

/// Returns the texture's point where the gizmo should be: the present `anchor`, else the texture's
/// origin, each if inside `sphere`, else the point at `centre`. `sphere` and `centre` are in the
/// scene.
Vec3d gizmo_anchor(const GizmoView& view, const SolidOptions& solid,
                   const std::optional<Vec3d>& anchor, const Sphere& sphere, const Vec3d& centre);

/// Returns the points of a ring, a closed polygon in the scene.
std::vector<Vec3d> ring_points(const SolidGizmo& gizmo, int axis);
Vec3d arrow_tip(const SolidGizmo& gizmo, int axis);

/// Whether a handle can be dragged: false for arrows seen end on and for a gizmo behind the camera.
bool can_be_held(const SolidGizmo& gizmo, const GizmoView& view, const GizmoHandle& handle);

/// Returns the handle within `gizmo_reach` of a pixel: the square if it is, otherwise the nearest.
std::optional<GizmoHandle> handle_at(const SolidGizmo& gizmo, const GizmoView& view,
                                     const Vec2d& pixel);

/// Returns a pixel where handle_at() finds this handle; empty where others hide it.
std::optional<Vec2d> place_of(const SolidGizmo& gizmo, const GizmoView& view,
                              const GizmoHandle& handle);

/// Returns the transform after a handle was pulled from one pixel to another, `gizmo` being the
/// gizmo at the press: an arrow's point stays under the pointer along its axis, a ring turns with
/// the pointer, and 100 pixels to the right or up double the texture's size. Empty where the
/// pointer has no meaning, as beyond an arrow's vanishing point.
std::optional<SolidOptions> pulled(const SolidOptions& start, const SolidGizmo& gizmo,
                                   const GizmoView& view, const GizmoHandle& handle,
                                   const Vec2d& from, const Vec2d& to);

}  // namespace burl
