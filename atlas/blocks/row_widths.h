#pragma once
// Whole-texel widths of the cells in one row, filling it exactly.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/blocks/strips.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Width of the cell when its horizontal leg is one texel long; `first`: it begins a row.
std::uint32_t narrowest_width(const Cell& cell, bool first, Overscan mode);

/// The narrowest widths of a row, summed.
std::uint64_t narrowest_row(std::span<const Cell> row, Overscan mode);

/// Widths that add up to `width`, legs in proportion to the cells' weights. Requires
/// narrowest_row(row) <= width.
std::vector<std::uint32_t> row_widths(std::span<const Cell> row, Overscan mode, std::uint32_t width,
                                      std::uint32_t height);

/// Integers that add up to `total`, each floor or ceiling of its part, by largest remainder (ties
/// to the first). The parts must add up to `total` but for rounding.
std::vector<std::uint32_t> whole_parts(std::span<const double> parts, std::uint32_t total);

}  // namespace burl
