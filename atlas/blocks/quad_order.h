#pragma once
// Which cells of the quad atlas lie together: recursive coordinate bisection of the cells' centres
// by weighted median (quad_graph has the other way). Everything is decided on integers, so that the
// mesh's unit of length does not matter and no two runs differ.
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "atlas/blocks/quad_cells.h"

namespace burl {

struct QuadItem {
    std::array<std::uint32_t, 3> key{};  ///< centre in 2^-24 of the longest side of their box
    std::uint32_t cell = 0;
    std::uint64_t weight = 0;  ///< share of the texture wanted, in 2^-20 texels, borders included
};

/// Texels round a block of width x height: the gutter asked for, halved until it is an eighth of
/// the shorter side at most. Nearest lookups need none.
std::uint32_t quad_gutter(const AtlasOptions& options, std::uint32_t width, std::uint32_t height);

/// One item per cell, in the cells' order.
std::vector<QuadItem> quad_items(std::span<const QuadCell> cells, const AtlasOptions& options);

/// How many items the first of two halves may have: 1 <= least <= most < items.
struct HalfBounds {
    std::size_t least = 1, most = 1;
};

/// Reorders two or more items so that the first k (returned) are one half, with about half the
/// weight.
struct Halve {
    std::function<std::size_t(std::span<QuadItem> items, const HalfBounds& bounds)> run;
    bool apart = false;  ///< several threads may halve items of their own at a time
};

/// By coordinates.
std::size_t halve_by_place(std::span<QuadItem> items, const HalfBounds& bounds);

}  // namespace burl
