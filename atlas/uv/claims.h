#pragma once
// Which triangle of a uv atlas each texel belongs to, before anything is continued.
#include <cstdint>
#include <limits>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// A texel that no triangle claims.
inline constexpr std::uint32_t unclaimed = std::numeric_limits<std::uint32_t>::max();

/// The texels that triangles claim.
struct UvClaims {
    /// The first triangle that holds the texel's centre, inside or on its border.
    Image<std::uint32_t> owner;
    std::uint64_t shared_texels = 0;      ///< texels with their centre inside several triangles
    std::uint64_t sharing_triangles = 0;  ///< triangles that such a centre lies inside of
};

/// Whether the triangle has an area in a texture of `texture_area`, in squared units of the
/// corners: more than 1e-20 of it, a square whose side is 1e-10 of the texture's. Maps of smaller
/// ones could leave the range of numbers.
bool has_texture_area(const std::array<Vec2d, 3>& corners, double texture_area);

/// The claims of all triangles with area in a texture of the atlas's columns and rows.
UvClaims claim_texels(const Atlas& atlas);

}  // namespace burl
