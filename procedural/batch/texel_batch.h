#pragma once
// Batches of texels, and the rules of host synthesis: kernels are vectorised for the machine's
// instruction set (Highway, chosen at run time) and give the same bits on every one, because they
// use only additions, multiplications and conversions that IEEE 754 rounds, nothing fused, no sums
// across lanes.
#include <cstddef>
#include <cstdint>

#include "atlas/base/vec.h"

namespace burl {

/// The elements that every array holds beyond its texels, because kernels write whole vectors.
inline constexpr std::size_t batch_padding = 16;
/// The largest number of texels in a batch, whose arrays (28 bytes a texel) then just fit the L1
/// cache.
inline constexpr std::size_t batch_capacity = 1024;

/// Texels along a line of solid or lattice coordinates: texel j lies at start + (first + j) * step.
struct LatticeLine {
    Vec3d start{0.0}, step{0.0};
    double first = 0.0;
    std::size_t count = 0;
};

/// A piece of an atlas's span: consecutive texels of one row of the image, with the line of solid
/// points that they show.
struct Piece {
    std::size_t x = 0, y = 0;
    LatticeLine solid;
    /// The change of the solid point to the next row.
    Vec3d down{0.0};
    double length = 0.0;  ///< texels of the whole span, or 0 where this piece is all of it
};

/// The parallelogram of the solid that a sample covers: the solid point moves by `u` and by `v`
/// across it. Zero: a point sample.
struct Footprint {
    Vec3d u{0.0}, v{0.0};
};

/// A texel's solid point and the point's steps to the next column and row: all that a texture
/// evaluated texel by texel needs to know of the atlas.
struct TexelPlace {
    std::uint32_t x = 0, y = 0;
    std::uint32_t map = 0;  ///< index into SolidAtlas::maps of the texel's span
    Vec3d point{0.0};
    Footprint steps;
};

}  // namespace burl
