#pragma once
// Orientation of each block of the quad atlas: half or quarter turns that cost nothing are chosen
// such that surface points on both sides of a border between blocks are near each other.
#include <span>
#include <vector>

#include "atlas/blocks/quad_tree.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Sets `turned` of the leaves that may turn, and `exchanged` of pairs. Every leaf must have at
/// least one texel of its own; places stay as they are.
void turn_to_neighbours(std::span<QuadLeaf> leaves, std::span<const QuadCell> cells,
                        const Mesh& mesh);

}  // namespace burl
