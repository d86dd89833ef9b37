#pragma once
// Ownership of a block's texels, and the number of overscan columns that keep a lookup inside one
// triangle from reading the other (Carr & Hart 2001, section 4.1). The paper's single column is
// right for nearest lookup and equal integer legs; the general counts are derived in
// docs/reference/atlases.md. Everything is decided in integers.
#include <cstdint>

#include "atlas/solid/atlas.h"

namespace burl {

/// Texels that a block has beyond its leg's length: 1 when corners lie on texel centres (bilinear),
/// else 0.
std::uint32_t border_texels(Overscan mode);

/// Smallest number of columns by which `upper` must be shifted so that no texel is read from both
/// triangles of a block with these legs (texels, >= 1). Triangles that share their hypotenuse need
/// none.
std::uint32_t overscan_columns(Overscan mode, std::uint32_t leg_x, std::uint32_t leg_y);

/// Longest horizontal leg, in texels, of two unrelated triangles in a block `width` columns wide;
/// at least 1.
std::uint32_t longest_leg(Overscan mode, std::uint32_t width, std::uint32_t leg_y);

/// Number of texels of the block's row j (0-based from block.y) that belong to `lower`: the block's
/// first columns, in a rising block its last. 0 <= split <= block.width.
std::uint32_t split(const Block& block, Overscan mode, std::uint32_t j);

}  // namespace burl
