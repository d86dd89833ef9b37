#pragma once
// An atlas cut to the texels that somebody asks for. A texel of the part gets the bytes it has in
// the whole: coordinates are still worked out from the whole span's start, and what is decided by a
// span's length is decided by the whole one's.
#include "atlas/solid/solid_atlas.h"
#include "atlas/solid/texel_set.h"

namespace burl {

/// The parts of the spans, from left to right, that lie in `wanted`, which is as large as the
/// atlas. Of an atlas that is cut already, spans are parts of the same whole ones.
SolidAtlas cut_to(const SolidAtlas& solid, const TexelSet& wanted);

/// Texels of all spans.
std::uint64_t texel_count(const SolidAtlas& solid);

}  // namespace burl
