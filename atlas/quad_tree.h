#pragma once
// The quadtree of the quad atlas: the texture square is halved exactly at every node down to one
// block per cell, so it is always full, and blocks are powers of two at multiples of their sides
// (Carr & Hart 2001, section 4.3: the balanced quadtree of the multiresolution atlas, here with
// halves and weights).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/quad_cells.h"

namespace burl {

/// The block [x, x+width) x [y, y+height) of a cell. Turned: x legs stand upright.
struct QuadLeaf {
    std::uint32_t cell = 0;
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
    bool turned = false;
};

/// Leaves in the tree's order. `size` is a power of two, and there are at most size^2 cells.
std::vector<QuadLeaf> plan_quad_tree(std::span<const QuadCell> cells, std::uint32_t size,
                                     Overscan overscan);

}  // namespace burl
