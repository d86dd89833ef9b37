#pragma once
// Lattice maps filled on the host: the numbers that synthesis works with (Carr & Hart 2001, section
// 5.1), from spans packed into the same batches, stored instead of evaluated.
#include <optional>

#include "atlas/solid/solid_atlas.h"
#include "procedural/field/lattice_map.h"

namespace burl {

/// The lattice map of an area, which must lie in the atlas. `maps` are the atlas's maps in the
/// texture's space (moved_maps); `quadric` is stored without the octaves' offsets. `threads` 0
/// means all.
LatticeMap fill_lattice_map(const SolidAtlas& solid, std::span<const TexelMap> maps,
                            const std::optional<LatticeStreamKey>& stream,
                            const std::optional<Quadric>& quadric, const TexelArea& area,
                            int threads);

}  // namespace burl
