#pragma once
// Handles on a texture's frame, seen over the object: arrows along its axes that move the texture,
// rings about them that turn it, and a square in their middle that makes it larger. Of a size on
// the screen, whatever the distance; without any user interface.
#include <array>
#include <optional>
#include <vector>

#include "app/recipe/recipe.h"
#include "app/scene/camera.h"

namespace burl {

/// A picture of the scene, as the pointer sees it.
struct GizmoView {
    Camera camera{};
    PictureSize size{};
    Affine3 solid_from_scene{};  ///< a scale and a move
};

struct SolidGizmo {
    Vec3d centre{0.0};                                             ///< in the scene
    std::array<Vec3d, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< s, t and r there; length 1
    double length = 1.0;                                           ///< of an arrow, in the scene
};

inline constexpr double gizmo_ring = 0.75;   ///< radius of the rings, in arrows
inline constexpr double gizmo_reach = 7.0;   ///< pixels from a handle that still count as on it
inline constexpr double gizmo_square = 8.0;  ///< half the side of the square, in pixels

enum class GizmoPart { arrow, ring, square };

struct GizmoHandle {
    GizmoPart part = GizmoPart::square;
    int axis = 0;  ///< of arrows and rings
    bool operator==(const GizmoHandle&) const = default;
};

/// The square, then the arrows, then the rings.
inline constexpr std::array<GizmoHandle, 7> gizmo_handles{{{GizmoPart::square, 0},
                                                           {GizmoPart::arrow, 0},
                                                           {GizmoPart::arrow, 1},
                                                           {GizmoPart::arrow, 2},
                                                           {GizmoPart::ring, 0},
                                                           {GizmoPart::ring, 1},
                                                           {GizmoPart::ring, 2}}};

/// The frame of the texture whose point `anchor` (texture coordinates) the gizmo stands at, with
/// arrows of so many pixels where they are seen from the side.
SolidGizmo gizmo_of(const GizmoView& view, const SolidOptions& solid, const Vec3d& anchor,
                    double pixels);

/// The texture's point that the gizmo should stand at: where it stands, the texture's origin or
/// what lies at `centre`, the first of these that is within the sphere. All in the scene.
Vec3d gizmo_anchor(const GizmoView& view, const SolidOptions& solid,
                   const std::optional<Vec3d>& anchor, const Sphere& sphere, const Vec3d& centre);

/// Points of a ring, which is closed.
std::vector<Vec3d> ring_points(const SolidGizmo& gizmo, int axis);
Vec3d arrow_tip(const SolidGizmo& gizmo, int axis);

/// False for arrows seen end on, which no pointer can pull.
bool can_be_held(const SolidGizmo& gizmo, const GizmoView& view, const GizmoHandle& handle);

/// What is at a pixel of the picture; the nearest where several are, the square before all.
std::optional<GizmoHandle> handle_at(const SolidGizmo& gizmo, const GizmoView& view,
                                     const Vec2d& pixel);

/// A pixel where a handle can be taken; empty where others hide it.
std::optional<Vec2d> place_of(const SolidGizmo& gizmo, const GizmoView& view,
                              const GizmoHandle& handle);

/// The texture with a handle pulled from one pixel to another, as the gizmo was when it was taken:
/// an arrow's point stays under the pointer along its line, a ring turns with it, and a hundred
/// pixels to the right or up make the texture twice as large. Empty where the pointer says nothing,
/// as beyond an arrow's vanishing point.
std::optional<SolidOptions> pulled(const SolidOptions& start, const SolidGizmo& gizmo,
                                   const GizmoView& view, const GizmoHandle& handle,
                                   const Vec2d& from, const Vec2d& to);

}  // namespace burl
