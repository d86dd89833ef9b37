#pragma once
// An atlas cut to a set of texels. A texel gets the same bytes in the part as in the whole atlas:
// its coordinates are still worked out from the whole span's start, and what depends on a span's
// length depends on the whole span's.
#include "atlas/solid/solid_atlas.h"
#include "atlas/solid/texel_set.h"

namespace burl {

/// The parts of the spans, from left to right, that lie in `wanted`, a set for a texture of the
/// atlas's size. An atlas that is cut already keeps its whole spans.
SolidAtlas cut_to(const SolidAtlas& solid, const TexelSet& wanted);

/// Number of texels of all spans.
std::uint64_t texel_count(const SolidAtlas& solid);

}  // namespace burl
