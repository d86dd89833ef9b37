#pragma once
// Where a texel lies in the solid and what it covers: all that a texture evaluated texel by texel
// needs to know of the atlas.
#include <cstdint>

#include "atlas/base/vec.h"

namespace burl {

/// What a sample covers: the solid point moves by `u` and by `v` across it. Zero: a point sample.
struct Footprint {
    Vec3d u{0.0}, v{0.0};
};

/// A texel's point and its steps to the next column and row, in texture coordinates.
struct TexelPlace {
    std::uint32_t x = 0, y = 0;
    std::uint32_t map = 0;  ///< its span's, into SolidAtlas::maps
    Vec3d point{0.0};
    Footprint steps;
};

}  // namespace burl
