#pragma once
// Packing of blocks with sides of powers of two into a rectangle, each at multiples of its sides,
// so that MIP levels mix blocks only where a block is smaller than their texels.
#include <cstdint>
#include <span>
#include <vector>

namespace burl {

/// A block of 2^log_width x 2^log_height texels; pack_blocks() sets its place (x, y).
struct PackedBlock {
    int log_width = 0, log_height = 0;
    std::uint32_t x = 0, y = 0;
};

/// Sides of the packed rectangle in texels.
struct PackedSize {
    std::uint32_t width = 0, height = 0;
};

/// Places the blocks and returns the rectangle's sides. The width is the power of two, from the
/// widest block's to `most_width`, with the least area, where every doubling of the sides' ratio
/// counts as 3 % more area. Rows are as high as the highest block still to be placed; the rest of a
/// row beside a block is halved down for smaller blocks.
PackedSize pack_blocks(std::span<PackedBlock> blocks, std::uint32_t most_width);

}  // namespace burl
