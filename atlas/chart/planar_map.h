#pragma once
// Maps of flat patches: a flat patch needs no map onto a full rectangle, it is drawn as it is, in
// the rectangle of least area round it. Whatever its outline, holes and slivers, the solid point is
// then one affine function of the texel over the whole block, so a lookup is exact everywhere and
// no gutter can be wrong.
#include <optional>

#include "atlas/chart/patch.h"
#include "atlas/chart/stretch.h"

namespace burl {

/// The projection of a patch into a rectangle of its plane.
struct PlanarMap {
    std::vector<Vec2d> uv;             ///< place of each vertex in the unit square
    Vec3d origin{0.0};                 ///< surface point of uv = (0,0)
    Vec3d along_u{0.0}, along_v{0.0};  ///< sides: s(u,v) = origin + u along_u + v along_v
    Stretch stretch;  ///< stretch; its distortion is the rectangle's area over the patch's
};

/// The map of a connected patch whose triangles all face one way in one plane (normals' sum at
/// least 0.9999 of the area, no thicker than 0.002 of the area's root, no triangle reversed, none
/// over another by more than most_overlap or a quarter of the lesser side); nothing for any other.
std::optional<PlanarMap> map_planar(const Patch& patch);

}  // namespace burl
