#pragma once
// Fills lattice maps on the host: the numbers that synthesis works with (Carr & Hart 2001, section
// 5.1), spans packed into the same batches, stored instead of evaluated.
#include <optional>

#include "atlas/solid/solid_atlas.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// `maps` are those of the atlas in the texture's space (moved_maps), q is without the octaves'
/// offsets. The area lies in the atlas. `threads` 0 means all.
LatticeMap fill_lattice_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                            const std::optional<LatticeStreamKey>& stream,
                            const std::optional<Quadric>& quadric, const TexelArea& area,
                            int threads);

}  // namespace burl
