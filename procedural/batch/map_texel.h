#pragma once
// The pieces that all images are made of which a graphics processor evaluates a texture from.
#include <cstdint>

#include "atlas/base/vec.h"

namespace burl {

/// Texels of an atlas: columns x to x + width - 1 of rows y to y + height - 1.
struct TexelArea {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Four words, whatever the image keeps in them.
using MapTexel = glm::uvec4;

}  // namespace burl
