#pragma once
// Fewer colours, for pictures that must be small: a palette by median cut (Heckbert, "Color Image
// Quantization for Frame Buffer Display", 1982), refined by two of Lloyd's steps.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

/// Pixels as numbers of colours. Colours ascend by luminance.
struct IndexedImage {
    Image<std::uint8_t> pixels;
    std::vector<Rgb8> colors;  ///< at most 256
};

/// At most `count` (1 to 256) colours, means of those they stand for, in sRGB codes; the image's
/// own where it has no more. The image has at least one pixel.
IndexedImage with_palette(const Image<Rgb8>& image, std::size_t count);

/// A PNG of at most `limit` bytes: all colours if they fit, else the largest palette that does.
/// Throws Error(runtime) where 8 colours do not fit either.
std::vector<std::uint8_t> encode_small_png(const Image<Rgb8>& image, std::size_t limit);

}  // namespace burl
