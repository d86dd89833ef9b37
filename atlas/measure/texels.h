#pragma once
// Measures by the texel: the texels that the surface can read, and those that show more than one
// place of it.
#include <cstdint>

#include "atlas/solid/atlas.h"

namespace burl {

/// Numbers of texels and triangles.
struct TexelMetrics {
    std::uint64_t readable = 0;    ///< texels that a lookup at some surface point reads
    std::uint64_t covered = 0;     ///< texels whose centre lies in or on a triangle
    std::uint64_t overlapped = 0;  ///< texels whose centre lies inside more than one triangle
    std::uint64_t outside = 0;     ///< triangles that leave the texture by more than 1e-6 texel
};

/// Counts the texels. A bilinear lookup (nearest: a whole texel) reads a texel from less than one
/// (half a) texel away in x and in y. A centre is inside a triangle by more than 1e-6 texel in x
/// and y, so triangles that share an edge do not overlap. Triangles outside the texture are
/// counted, and clipped.
TexelMetrics measure_texels(const Atlas& atlas);

}  // namespace burl
