#pragma once
// Places of the corners of a block's triangles, in texels.
#include <array>

#include "atlas/solid/atlas.h"

namespace burl {

/// Corners of a block's two triangles: the right angle first, then counterclockwise in (x right, y
/// up). After the right angle come the ends of the horizontal and the vertical leg for both
/// triangles (`upper` is turned by 180 degrees), in a rising block of the vertical and the
/// horizontal one.
struct BlockCorners {
    std::array<Vec2d, 3> lower{}, upper{};
};

/// Corners that lookups use. Bilinear: at texel centres. Nearest: at texel edges, pulled in by 1/32
/// texel wherever a lookup could slip into a texel of another block or triangle. `joins_right` is
/// the next block's joins_left.
BlockCorners block_corners(const Block& block, Overscan mode, bool joins_right);

/// Corners that a collapsed block is sampled with: its texel-centre corners spread over the texel's
/// width, so that the affine map between triangle and texture exists and the texels, read by all
/// lookups across, show the middle.
BlockCorners sampled_corners(const Block& block);

}  // namespace burl
