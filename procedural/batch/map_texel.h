#pragma once
// Rectangles of texels, and the texels of the images that a graphics processor evaluates a texture
// from.
#include <cstdint>

#include "atlas/base/vec.h"

namespace burl {

/// A rectangle of texels of an atlas: columns x to x + width - 1 of rows y to y + height - 1.
struct TexelArea {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// A texel of four 32-bit words, whose meaning is up to the image.
using MapTexel = glm::uvec4;

}  // namespace burl
