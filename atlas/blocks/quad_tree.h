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

/// The block [x, x+width) x [y, y+height) of a cell.
struct QuadLeaf {
    std::uint32_t cell = 0;
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    bool turned = false;  ///< x legs of the triangles lie along y
    /// The leaf lies on the one texel of an earlier leaf, which stands for both.
    bool shares_texel = false;
    bool exchanged = false;  ///< block's lower triangle is the cell's upper one
    bool may_turn = false;   ///< `turned` makes little difference to the block's error
    /// Numbers of the leaves beyond the middles of the sides, by QuadSide; no_spot where there is
    /// none (and everywhere when leaves share texels).
    std::array<std::uint32_t, 4> beside{no_spot, no_spot, no_spot, no_spot};
};

/// Leaves for all cells, in the tree's order; options.size is a power of two. When there are more
/// cells than texels, all blocks are single texels, and the first leaf on a texel is the cell
/// nearest to the centre of the cells there.
std::vector<QuadLeaf> plan_quad_tree(std::span<const QuadCell> cells, const AtlasOptions& options,
                                     const Halve& halve);

}  // namespace burl
