#pragma once
// A block's two triangles: the places of their corners, who owns which texel, and the number of
// overscan columns that keep a lookup inside one triangle from reading the other (Carr & Hart 2001,
// section 4.1). The paper's single column is right for nearest lookup and equal integer legs; the
// general counts are derived in docs/reference/atlases.md. Owners are decided in integers.
#include <array>
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

/// Places, in texels, of the corners of a block's two triangles: the right angle first, then
/// counterclockwise in (x right, y up). After it come the ends of the horizontal and the vertical
/// leg for both triangles (`upper` is turned by 180 degrees), in a rising block of the vertical and
/// the horizontal one.
struct BlockCorners {
    std::array<Vec2d, 3> lower{}, upper{};
};

/// Sets atlas.corners of the block's triangles to the places that lookups use. Bilinear: texel
/// centres. Nearest: texel edges, pulled in by 1/32 texel wherever a lookup could slip into a texel
/// of another block or triangle. `joins_right` is the next block's joins_left.
void place_corners(Atlas& atlas, const Block& block, bool joins_right);

/// Corners that a collapsed block is sampled with: its texel-centre corners spread over the texel's
/// width, so that the affine map between triangle and texture exists and the texels, read by all
/// lookups across, show the middle.
BlockCorners sampled_corners(const Block& block);

}  // namespace burl
