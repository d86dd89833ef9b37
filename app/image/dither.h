#pragma once
// Pictures with the colours of a palette alone, whose errors the eye averages out.
#include <cstdint>
#include <span>

#include "atlas/base/image.h"

namespace burl {

/// The index of a palette's colour for every pixel, by error diffusion in sRGB codes (Floyd and
/// Steinberg, "An Adaptive Algorithm for Spatial Grey Scale", 1976), rows to the right and to the
/// left in turn. A pixel whose colour the palette has gets that colour, whatever its neighbours'
/// errors, so that flat areas stay flat. The palette has 1 to 256 colours.
Image<std::uint8_t> dithered(const Image<Rgb8>& image, std::span<const Rgb8> palette);

}  // namespace burl
