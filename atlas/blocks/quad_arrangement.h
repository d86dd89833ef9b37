#pragma once
// Which half of a quadtree node comes first. Halves may be exchanged freely, so they are laid so
// that clusters that are near on the surface are near in the texture: lookups that read across a
// block's side, and levels' texels that are larger than blocks, then mix less unlike things.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

inline constexpr int most_quad_aspect = 16;  ///< of |log2(width / height)| of a node

/// Nodes are numbered in preorder: the halves of node i are i + 1 and i + 2 * half, which is the
/// number of items in the first.
struct QuadNode {
    std::uint64_t upright = 0;  ///< bit aspect + most_quad_aspect: halved in height, not in width
    std::uint32_t first = 0, count = 0, half = 0;  ///< items; half is 0 for a leaf
    Vec3d centre{0.0};                             ///< of the items, in any unit
};

/// 2^log_width x 2^log_height texels at a multiple of its sides.
struct QuadPlace {
    std::uint32_t x = 0, y = 0;
    int log_width = 0, log_height = 0;
};

enum QuadSide : std::size_t { quad_left, quad_right, quad_below, quad_above };
inline constexpr std::array<QuadSide, 4> quad_sides{quad_left, quad_right, quad_below, quad_above};
inline constexpr std::uint32_t no_spot = UINT32_MAX;

struct QuadSpot {
    std::uint32_t node = 0;
    QuadPlace at;
    /// Numbers of the spots at the middles of the sides, by QuadSide; no_spot at the square's ends.
    std::array<std::uint32_t, 4> beside{no_spot, no_spot, no_spot, no_spot};
};

/// The leaves of nodes[0] in a square of 2^log_size texels a side, in the order of the tree. Level
/// by level from the root every node's halves take the order in which the squared distances to what
/// lies beside them, weighed by the length of the common side, are least. Time is in proportion to
/// nodes times the depths that leaves differ by.
std::vector<QuadSpot> arrange(std::span<const QuadNode> nodes, int log_size);

}  // namespace burl
