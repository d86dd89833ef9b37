#pragma once
// Blocks with sides of powers of two into a rectangle, each at multiples of its sides, so that MIP
// levels mix blocks only where a block is smaller than their texels.
#include <cstdint>
#include <span>
#include <vector>

namespace burl {

/// 2^log_width x 2^log_height texels; x and y are where pack_blocks puts it.
struct PackedBlock {
    int log_width = 0, log_height = 0;
    std::uint32_t x = 0, y = 0;
};

struct PackedSize {
    std::uint32_t width = 0, height = 0;
};

/// Sets x and y. The width is a power of two from the widest block's to `most_width`, the one whose
/// area is least, 3 % dearer per doubling of the sides' ratio. Rows are as high as the highest
/// block still to place; what a block leaves of its row is halved down for the smaller ones.
PackedSize pack_blocks(std::span<PackedBlock> blocks, std::uint32_t most_width);

}  // namespace burl
