#pragma once
// Compression of a texture: blocks of a quad atlas that look alike share one place in the texture,
// which shrinks by the texels saved (proposed as future work in Carr & Hart 2001, section 6).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Figures of a compression.
struct CompressNotes {
    std::uint64_t blocks = 0, places = 0;  ///< blocks with texels of their own, before and after
    std::uint64_t texels_before = 0, texels_after = 0;  ///< texels of the texture
    double largest_error = 0.0;  ///< largest change of a stored channel of a texel, full scale 1
};

template <class Pixel>
struct Compressed {
    Atlas atlas;  ///< same blocks and charts; blocks and corners moved, width and height set
    Image<Pixel> image;
    CompressNotes notes;
};

/// The atlas and its texture with alike blocks merged. Two blocks of the same sides share a place
/// when no channel of any texel differs by more than `most_error` (0 to 1: full scale of the stored
/// numbers). Blocks keep their texels' alignment: each lies at multiples of its sides. When nothing
/// is saved, atlas and image stay as they are. Deterministic, and in nearly linear time: a block is
/// compared with only the latest few of the blocks with a similar mean colour. Throws Error(usage)
/// for other kinds than quad. Pixel is Rgb8, Rgb16 or RgbF.
template <class Pixel>
Compressed<Pixel> compress_blocks(Atlas atlas, const Image<Pixel>& image, double most_error);

/// A block of 2^log_width x 2^log_height texels; pack_blocks() sets its place (x, y).
struct PackedBlock {
    int log_width = 0, log_height = 0;
    std::uint32_t x = 0, y = 0;
};

/// Sides of the packed rectangle in texels.
struct PackedSize {
    std::uint32_t width = 0, height = 0;
};

/// Places the blocks in a rectangle, each at multiples of its sides, so that MIP levels mix blocks
/// only where a block is smaller than their texels, and returns its sides. The width is the power
/// of two, from the widest block's to `most_width`, with the least area, where every doubling of
/// the sides' ratio counts as 3 % more area. Rows are as high as the highest block still to be
/// placed; the rest of a row beside a block is halved down for smaller blocks.
PackedSize pack_blocks(std::span<PackedBlock> blocks, std::uint32_t most_width);

}  // namespace burl
