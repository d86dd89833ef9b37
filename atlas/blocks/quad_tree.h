#pragma once
// The quadtree of the quad atlas: the texture square is halved exactly at every node down to one
// block per cell, so it is always full, and blocks are powers of two at multiples of their sides
// (Carr & Hart 2001, section 4.3: the balanced quadtree of the multiresolution atlas, here with
// halves and weights).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/blocks/quad_arrangement.h"
#include "atlas/blocks/quad_cells.h"
#include "atlas/blocks/quad_order.h"

namespace burl {

/// The block [x, x+width) x [y, y+height) of a cell. Turned: x legs stand upright.
struct QuadLeaf {
    std::uint32_t cell = 0;
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    bool turned = false;
    bool shares_texel = false;  ///< on the one texel of a leaf before, which stands for both
    bool exchanged = false;     ///< the lower triangle is the cell's upper one
    bool may_turn = false;      ///< turned or not makes no difference
    /// Numbers of the leaves at the middles of the sides, by QuadSide; no_spot where there is none
    /// (and everywhere when leaves share texels).
    std::array<std::uint32_t, 4> beside{no_spot, no_spot, no_spot, no_spot};
};

/// Leaves in the tree's order; options.size is a power of two. When there are more cells than
/// texels, all blocks are single texels, and cells that one of them stands for follow the one
/// nearest to their middle.
std::vector<QuadLeaf> plan_quad_tree(std::span<const QuadCell> cells, const AtlasOptions& options,
                                     const Halve& halve);

}  // namespace burl
