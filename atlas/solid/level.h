#pragma once
// MIP levels (Williams, "Pyramidal Parametrics", 1983) of an atlas's points rather than of its
// colours: a level's texels are affine maps like those of level 0, with steps as long as the
// level's texels are wide. A filter of level 0's texels therefore filters those of level L by their
// own width, and nothing of level 0 need be worked out.
#include <cstdint>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Side of level L, in texels, of a texture of `size` texels a side: max(1, floor(size / 2^L)), as
/// in OpenGL.
std::uint32_t level_size(std::uint32_t size, std::uint32_t level);

/// The atlas's texture with `size` texels a side, each solid.size / size old texels wide: texel
/// (i,j) belongs to the map that owns the place of its centre, moved there; a centre on the sides
/// of several texels belongs to the one of higher x and y. Places without a map stay without one.
/// Maps that no texel uses are left out, and triangle_of() still names the triangles. `size` may
/// exceed solid.size; both are >= 1.
SolidAtlas resized(const SolidAtlas& solid, std::uint32_t size);

/// Level L of the atlas: the atlas resized to level_size().
SolidAtlas solid_level(const SolidAtlas& solid, std::uint32_t level);

}  // namespace burl
