#pragma once
// Rows of blocks that fill an N x N texture exactly: the cells of each row, the rows' heights and
// the cells' widths (Carr & Hart 2001, section 4.2: triangles in non-increasing order, sized by the
// inverse of their relative scale).
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

/// Rows and widths of all cells of a strip atlas.
struct RowPlan {
    std::vector<CellRow> rows;          ///< empty when the cells do not fit; heights add up to N
    std::vector<std::uint32_t> widths;  ///< cells' widths in texels; a row's add up to N
};

/// Rows and widths for the cells, in their order, such that leg_x * leg_y is in proportion to the
/// cells' weights as far as whole texels allow, and legs are about equal. The texture has `size`
/// texels a side. The first cell of a row is never joined to the cell before it.
RowPlan plan_rows(std::span<const Cell> cells, Overscan mode, std::uint32_t size);

}  // namespace burl
