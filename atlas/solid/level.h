#pragma once
// MIP levels (Williams, "Pyramidal Parametrics", 1983) of an atlas's points rather than of its
// colours: a level's texels are affine maps as level 0's are, with steps as long as the level's
// texels are wide, so that whatever filters a texel of level 0 filters one of level L by its own
// width, and nothing of level 0 need be worked out.
#include <cstdint>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Texels a side of level L of a texture of `size`: max(1, floor(size / 2^L)), as in OpenGL.
std::uint32_t level_size(std::uint32_t size, std::uint32_t level);

/// The same texture with `size` texels a side, each size/solid.size as wide: texel (i,j) belongs to
/// the map that owns the place of its centre, moved there; a centre on the sides of several texels
/// belongs to the one of higher x and y. What no centre meets has no map; maps that nothing shows
/// are left out, and triangle_of still names the triangles. Larger sizes than solid's work, too.
/// size >= 1, solid.size >= 1.
SolidAtlas resized(const SolidAtlas& solid, std::uint32_t size);

/// Level L of the atlas: resized to level_size.
SolidAtlas solid_level(const SolidAtlas& solid, std::uint32_t level);

}  // namespace burl
