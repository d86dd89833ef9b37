#pragma once
// Where the corners of a block's triangles lie, in texels.
#include <array>

#include "atlas/solid/atlas.h"

namespace burl {

/// Per triangle the right angle, then counterclockwise in (x right, y up): the ends of the
/// horizontal and vertical leg for both triangles (`upper` is turned by 180 degrees), in a rising
/// block of the vertical and horizontal one.
struct BlockCorners {
    std::array<Vec2d, 3> lower{}, upper{};
};

/// Bilinear: texel centres. Nearest: texel edges, pulled in by 1/32 texel wherever a lookup could
/// slip into a stranger's texel. `joins_right`: the next block's joins_left.
BlockCorners block_corners(const Block& block, Overscan mode, bool joins_right);

/// For collapsed blocks: the same spread over the texel's width, so that the affine map between
/// triangle and texture exists and the texels, read by all lookups across, show the middle.
BlockCorners sampled_corners(const Block& block);

}  // namespace burl
