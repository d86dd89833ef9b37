#pragma once
// Which triangle's shading frame a texel shows where its span does not say: the planar patches of a
// patch atlas are one span a row whatever their triangles, and holes are closed by none.
#include <cstdint>

#include "atlas/base/image.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

class FrameOwners {
  public:
    FrameOwners(const SolidAtlas& solid, const Atlas& atlas);

    /// The span's triangle where the span shows one; else the triangle of the same chart that the
    /// texel's centre lies in or, outside all, near (lookups read up to a texel beyond); else the
    /// one the span goes on from.
    std::uint32_t operator()(std::uint32_t x, std::uint32_t y, std::uint32_t map) const;

  private:
    const SolidAtlas& solid_;
    const Atlas& atlas_;
    Image<std::uint32_t> owners_;  ///< empty where every span is some triangle's own
};

}  // namespace burl
