#pragma once
// The spans of an atlas as an image: from it, and the maps of the triangles, a shader computes
// points beside the texels' centres (shaders/maps/texel_line.glsl).
#include "atlas/solid/solid_atlas.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// Four words per texel: the number of its span's map, the first column and the number of texels of
/// the whole span, and 0; no_owner and zeros where no span shows anything. The area must lie in the
/// atlas; `threads` 0 means all.
Image<MapTexel> fill_span_map(const SolidAtlas& solid, const TexelArea& area, int threads);

}  // namespace burl
