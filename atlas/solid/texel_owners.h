#pragma once
// Which triangle every texel shows. A span says so where its map is a triangle's own; the maps
// beyond those show several triangles (a planar patch has one map for all), none (a closed hole),
// or continue one into a gutter.
#include <cstdint>

#include "atlas/base/image.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The triangles of an atlas's texels. Both arguments must outlive the object; `solid` may be a
/// level of the atlas, or cut to some of its texels.
class TexelOwners {
  public:
    TexelOwners(const SolidAtlas& solid, const Atlas& atlas);

    /// The triangle of texel (x, y), which map number `map` shows: the map's own triangle where it
    /// has one; otherwise the triangle of the same chart that the texel's centre lies in or is
    /// nearest to; otherwise the triangle that the map continues.
    std::uint32_t operator()(std::uint32_t x, std::uint32_t y, std::uint32_t map) const;

  private:
    const SolidAtlas& solid_;
    const Atlas& atlas_;
    Image<std::uint32_t> owners_;  ///< empty if each map has one triangle
};

}  // namespace burl
