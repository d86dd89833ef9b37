#pragma once
// The triangle whose shading frame a texel has where its span has no single triangle: a planar
// patch of a patch atlas has one span per row whatever its triangles, and a closed hole has none.
#include <cstdint>

#include "atlas/base/image.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

class FrameOwners {
  public:
    FrameOwners(const SolidAtlas& solid, const Atlas& atlas);

    /// The span's triangle where the span shows a single one; otherwise the triangle of the same
    /// chart that the texel's centre lies in or is near to (lookups read up to a texel beyond);
    /// otherwise the triangle that the span continues.
    std::uint32_t operator()(std::uint32_t x, std::uint32_t y, std::uint32_t map) const;

  private:
    const SolidAtlas& solid_;
    const Atlas& atlas_;
    Image<std::uint32_t> owners_;  ///< owners; empty if each span has one triangle
};

}  // namespace burl
