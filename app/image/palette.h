#pragma once
// Reduced palettes for pictures that must be small: median cut (Heckbert, "Color Image Quantization
// for Frame Buffer Display", 1982), refined by two steps of Lloyd's algorithm.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/image.h"

namespace burl {

/// An image of palette indices. The colours ascend by luminance.
struct IndexedImage {
    Image<std::uint8_t> pixels;
    std::vector<Rgb8> colors;  ///< the palette, at most 256 colours
};

/// A palette of at most `count` (1 to 256) colours for these pixels, at least one, as with_palette
/// has it; they ascend by luminance.
std::vector<Rgb8> palette_of(std::span<const Rgb8> pixels, std::size_t count);

/// The image with a palette of at most `count` (1 to 256) colours: means, in sRGB codes, of the
/// colours they replace, or the image's own colours where it has no more. The image has at least
/// one pixel.
IndexedImage with_palette(const Image<Rgb8>& image, std::size_t count);

/// A PNG of at most `limit` bytes: with all colours where they fit, else with the largest palette
/// that does, of 256 down to 8 colours. Throws Error(runtime) where 8 colours do not fit either.
std::vector<std::uint8_t> encode_small_png(const Image<Rgb8>& image, std::size_t limit);

}  // namespace burl
