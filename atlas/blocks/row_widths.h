#pragma once
// Whole-texel widths of the cells in one row, filling it exactly.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/blocks/strips.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Width in texels of the cell when its horizontal leg is one texel long; `first` says that it
/// begins a row.
std::uint32_t narrowest_width(const Cell& cell, bool first, Overscan mode);

/// Sum of the narrowest widths of a row's cells, in texels.
std::uint64_t narrowest_row(std::span<const Cell> row, Overscan mode);

/// Widths of the cells, in texels, that add up to `width`, with horizontal legs in proportion to
/// the cells' weights; the row is `height` texels high. Requires narrowest_row(row) <= width.
std::vector<std::uint32_t> row_widths(std::span<const Cell> row, Overscan mode, std::uint32_t width,
                                      std::uint32_t height);

/// Integers that add up to `total`, each the floor or the ceiling of its part, by largest remainder
/// (ties go to the first). The parts must add up to `total` but for rounding.
std::vector<std::uint32_t> whole_parts(std::span<const double> parts, std::uint32_t total);

}  // namespace burl
