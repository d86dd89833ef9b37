#pragma once
// A texel's solid point and footprint: all that a texture evaluated texel by texel needs to know of
// the atlas.
#include <cstdint>

#include "atlas/base/vec.h"

namespace burl {

/// The parallelogram of the solid that a sample covers: the solid point moves by `u` and by `v`
/// across it. Zero: a point sample.
struct Footprint {
    Vec3d u{0.0}, v{0.0};
};

/// A texel's solid point and the point's steps to the next column and row.
struct TexelPlace {
    std::uint32_t x = 0, y = 0;
    std::uint32_t map = 0;  ///< index into SolidAtlas::maps of the texel's span
    Vec3d point{0.0};
    Footprint steps;
};

}  // namespace burl
