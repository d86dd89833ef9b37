#pragma once
// Which cells of the quad atlas lie together: recursive coordinate bisection of the cells' centres
// by weighted median. Everything is decided on integers, so that the mesh's unit of length does
// not matter and no two runs differ.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/quad_cells.h"

namespace burl {

struct QuadItem {
    std::array<std::uint32_t, 3> key{};  ///< centre in 2^-24 of the longest side of their box
    std::uint32_t cell = 0;
    std::uint64_t weight = 0;  ///< share of the texture wanted, in 2^-20 texels, borders included
};

/// One item per cell, in the cells' order, for a texture of size x size texels.
std::vector<QuadItem> quad_items(std::span<const QuadCell> cells, std::uint32_t size,
                                 Overscan overscan);

/// Reorders two or more items so that the first k (returned) are one half, with about half the
/// weight; k and size - k are at least 1 and at most `most` (2 * most >= items.size()).
std::size_t halve(std::span<QuadItem> items, std::size_t most);

}  // namespace burl
