#pragma once
// Which triangle every texel shows. A span says so where its map is a triangle's own; the maps
// beyond those show several triangles (a planar patch has one map for all), none (a closed hole),
// or continue one into a gutter.
#include <cstdint>

#include "atlas/base/image.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// How far beyond their chart's triangles texels get the nearest one: as far as lookups inside
/// triangles read, or as far as there are texels, which levels average.
enum class OwnerReach { lookups, gutters };

/// The triangles of an atlas's texels. Both references must outlive the object. `solid` may be a
/// level of the atlas; cut to some of its texels it has the same owners within reach of lookups.
class TexelOwners {
  public:
    TexelOwners(const SolidAtlas& solid, const Atlas& atlas, OwnerReach reach);

    /// The triangle of texel (x, y), which map number `map` shows: the map's own triangle where it
    /// has one; otherwise the triangle of the same chart that the texel's centre lies in or is
    /// near to; otherwise the triangle that the map continues.
    std::uint32_t operator()(std::uint32_t x, std::uint32_t y, std::uint32_t map) const;

  private:
    bool has_single_triangle(std::uint32_t map) const;
    Image<std::uint32_t> charts() const;

    const SolidAtlas& solid_;
    const Atlas& atlas_;
    Image<std::uint32_t> owners_;  ///< empty if each map has one triangle
};

}  // namespace burl
