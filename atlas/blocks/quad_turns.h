#pragma once
// How each block of the quad atlas is turned: by the half or quarter turns that cost nothing, so
// that a block's sides show what is near to what the blocks beside them show.
#include <span>
#include <vector>

#include "atlas/blocks/quad_tree.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Sets `turned` where the leaf may, and `exchanged` of pairs. Every leaf is one texel or more of
/// its own; places stay as they are.
void turn_to_neighbours(std::span<QuadLeaf> leaves, std::span<const QuadCell> cells,
                        const Mesh& mesh);

}  // namespace burl
