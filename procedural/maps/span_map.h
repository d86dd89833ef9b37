#pragma once
// Which span of an atlas every texel lies in, as an image: from it, and the maps of the triangles,
// a shader works out points beside the texels' centres (shaders/maps/texel_line.glsl).
#include "atlas/solid/solid_atlas.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// The number of the span's map, the first column and the number of texels of
/// the whole span, 0. Where no span shows
/// anything no_owner and zeros. The area lies in the atlas; `threads` 0 means all.
Image<MapTexel> fill_span_map(const SolidAtlas& solid, const TexelArea& area, int threads);

}  // namespace burl
