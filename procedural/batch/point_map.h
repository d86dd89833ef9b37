#pragma once
// The solid points of an atlas's texels as images: in float64 for octaves that have no vectorised
// kernel, and as float32 offsets from one base with each texel's owner, the solid map of an atlas
// (Carr & Hart 2001, section 5.1), from which a shader elsewhere textures it.
#include "atlas/base/image.h"
#include "procedural/batch/map_texel.h"

namespace burl {

/// The owner of texels outside every span.
inline constexpr std::uint32_t no_owner = 0xffffffffu;

/// Points in float64, each number as two 32-bit halves, the lower first; NaN outside every span.
struct PointMap {
    Image<MapTexel> xy;
    Image<MapTexel> z_owner;  ///< z, the number of the texel's map (Span::map) and 0
};

/// Offsets in float32: a texel's solid point is local plus a base point (maps/point_map.h).
struct SolidMap {
    Image<Vec4f> local;  ///< x, y, z and 1 in spans; all 0 elsewhere
    Image<std::uint32_t> owners;
};

}  // namespace burl
