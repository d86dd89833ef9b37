#pragma once
// Room between packed outlines. Packing sets each as low as it goes, so that many touch, while the
// cells that stay free lie together elsewhere. Lookups in coarse levels and long footprints read
// beyond the gutter: here outlines move, by whole cells and without turning, to where their borders
// read least of the others. Measured in docs/lab/chart-atlas.md.
#include <cstdint>
#include <span>

#include "atlas/outline/outline_mask.h"

namespace burl {

/// A mask with its low corner at a cell of the grid.
struct PlacedMask {
    const OutlineMask* mask = nullptr;
    std::uint32_t x = 0, y = 0;
};

/// Moves masks apart in a grid of `side` x `side` cells, in which none share a cell before or
/// after. Pure and deterministic.
void spread_masks(std::span<PlacedMask> masks, std::uint32_t side);

}  // namespace burl
