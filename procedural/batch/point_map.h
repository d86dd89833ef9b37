#pragma once
// The points that an atlas's texels show, as images: in float64 for octaves that no stream serves,
// and as float32 offsets from one base with each texel's owner, the solid map of an atlas (Carr &
// Hart 2001, section 5.1) that a shader textures from elsewhere.
#include "atlas/base/image.h"
#include "procedural/batch/map_texel.h"

namespace burl {

/// Of texels outside every span.
inline constexpr std::uint32_t no_owner = 0xffffffffu;

/// Points as halves of float64 numbers, the lower first; not numbers outside every span.
struct PointMap {
    Image<MapTexel> xy;
    Image<MapTexel> z_owner;  ///< z, the number of the texel's map (Span::map) and 0
};

/// Every texel's point is base + local.
struct SolidMap {
    Image<Vec4f> local;  ///< x, y, z; w is 1 in spans, all is 0 elsewhere
    Image<std::uint32_t> owners;
};

}  // namespace burl
