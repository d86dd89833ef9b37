#pragma once
// Cube maps on the host: which direction a texel sees, and which texel a direction.
#include <cstddef>

#include "app/light/prefilter.h"

namespace burl {

/// A point of a cube map: the face, and the place on it, both coordinates 0 to 1 from the first
/// texel's corner on.
struct CubePoint {
    std::size_t face = 0;
    Vec2d at{0.5};
};

/// The point that a direction of any length but 0 sees.
CubePoint cube_point(const Vec3d& direction);
/// The direction, not of length 1, that the point sees; `at` may lie beyond the face.
Vec3d cube_direction(const CubePoint& point);

/// The texel of a face at a column and row that may lie one beyond it, on a neighbour then.
Vec3d cube_texel(const CubeFaces& faces, std::size_t face, double x, double y);

/// The value a direction sees: bilinear, across the edges of faces, too.
Vec3d cube_lookup(const CubeFaces& faces, const Vec3d& direction);

/// The level of half the side: means of 2 x 2 texels by their solid angles.
CubeFaces halved(const CubeFaces& faces);

}  // namespace burl
