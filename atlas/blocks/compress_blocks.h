#pragma once
// Blocks of a quad atlas that look alike share one place in the texture, which shrinks by what they
// leave (proposed as future work in Carr & Hart 2001, section 6).
#include <cstdint>

#include "atlas/base/image.h"
#include "atlas/solid/atlas.h"

namespace burl {

struct CompressNotes {
    std::uint64_t blocks = 0, places = 0;  ///< blocks with texels of their own, before and after
    std::uint64_t texels_before = 0, texels_after = 0;
    double largest_error = 0.0;  ///< of any channel of any texel, as stored, full scale 1
};

template <class Pixel>
struct Compressed {
    Atlas atlas;  ///< same blocks and charts; blocks and corners moved, width and height set
    Image<Pixel> image;
    CompressNotes notes;
};

/// Two blocks of the same sides share a place when no channel of any texel differs by more than
/// `most_error` (0 to 1: full scale of the stored numbers). Blocks keep their texels' alignment:
/// each lies at multiples of its sides. When nothing is saved, atlas and image stay as they are.
/// Deterministic, and in nearly linear time: of blocks whose mean colours are alike the latest few
/// are compared. Throws Error(usage) for other kinds than quad. Pixel is Rgb8, Rgb16 or RgbF.
template <class Pixel>
Compressed<Pixel> compress_blocks(Atlas atlas, const Image<Pixel>& image, double most_error);

}  // namespace burl
