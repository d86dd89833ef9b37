#pragma once
// The order of the halves of quadtree nodes. Halves may be exchanged freely, so they are laid such
// that clusters that are near on the surface are near in the texture: lookups across a block's
// side, and MIP texels larger than blocks, then mix colours that differ less.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/vec.h"

namespace burl {

inline constexpr int most_quad_aspect = 16;  ///< limit of |log2(width / height)| of a node

/// A node of the quadtree, which holds a run of items. Nodes are numbered in preorder: the halves
/// of node i are nodes i + 1 and i + 2 * half, where `half` is the number of items in the first
/// half.
struct QuadNode {
    /// Bit aspect + most_quad_aspect is set where a node with that log2(width / height) is halved
    /// in height, not in width.
    std::uint64_t upright = 0;
    std::uint32_t first = 0, count = 0, half = 0;  ///< run of items; half 0: a leaf
    Vec3d centre{0.0};                             ///< mean place of the items, in any unit
};

/// A rectangle of 2^log_width x 2^log_height texels with its low corner at multiples of its sides.
struct QuadPlace {
    std::uint32_t x = 0, y = 0;
    int log_width = 0, log_height = 0;
};

/// The sides of a rectangle of texels: low x, high x, low y, high y.
enum QuadSide : std::size_t { quad_left, quad_right, quad_below, quad_above };
/// All sides, for loops.
inline constexpr std::array<QuadSide, 4> quad_sides{quad_left, quad_right, quad_below, quad_above};
/// Number that stands for no neighbour.
inline constexpr std::uint32_t no_spot = UINT32_MAX;

/// A node at its place in the texture.
struct QuadSpot {
    std::uint32_t node = 0;
    QuadPlace at;
    /// Numbers of the spots beyond the middles of the sides, by QuadSide; no_spot at the texture's
    /// borders.
    std::array<std::uint32_t, 4> beside{no_spot, no_spot, no_spot, no_spot};
};

/// The leaves of tree nodes[0] in a square of 2^log_size texels a side, in the order of the tree.
/// Level by level from the root, the halves of every node take the order with the smaller sum of
/// squared distances to the centres of the clusters beside them, weighted by the length of the
/// common side. Time is in proportion to the number of nodes times the differences between the
/// leaves' depths.
std::vector<QuadSpot> arrange(std::span<const QuadNode> nodes, int log_size);

}  // namespace burl
