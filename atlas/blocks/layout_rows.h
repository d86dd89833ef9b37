#pragma once
// Rows of blocks that fill an N x N texture exactly: which cells share a row, how high the rows
// and how wide the cells are (Carr & Hart 2001, section 4.2: triangles in non-increasing order,
// sized by the inverse of their relative scale).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/blocks/strips.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Cells [first, first+count) lie side by side in texel rows [y, y+height).
struct CellRow {
    std::size_t first = 0, count = 0;
    std::uint32_t y = 0, height = 0;
};

struct RowPlan {
    std::vector<CellRow> rows;          ///< empty when the cells do not fit; heights add up to N
    std::vector<std::uint32_t> widths;  ///< per cell, texels; a row's widths add up to N
};

/// Gives the cells, in their order, rows and widths such that leg_x * leg_y is in proportion to
/// the cells' weights as far as whole texels allow, and legs are about equal. The first cell of a
/// row is never joined to the one before it.
RowPlan plan_rows(std::span<const Cell> cells, Overscan mode, std::uint32_t size);

}  // namespace burl
