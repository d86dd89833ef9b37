// Corner positions for both overscans (Carr & Hart 2001, section 4.1, figure 4).
#include "atlas/solid/block_corners.h"

#include <cmath>

namespace burl {

namespace {

// Distance by which corners are pulled in. Graphics hardware snaps vertices to 1/256 pixel and then
// extrapolates the texture coordinate to the pixel's centre: where n texels meet a pixel a lookup
// can leave its triangle by n/256 texel. This distance covers 8 texels a pixel.
constexpr double pull_in_texels = 1.0 / 32.0;

BlockCorners right_triangles(const Vec2d& low, const Vec2d& high, double shift) {
    return {{low, Vec2d{high.x, low.y}, Vec2d{low.x, high.y}},
            {Vec2d{high.x + shift, high.y}, Vec2d{low.x + shift, high.y},
             Vec2d{high.x + shift, low.y}}};
}

/// The right triangle (right angle first) with its three edges moved in by pull_in_texels.
std::array<Vec2d, 3> pulled_in(const std::array<Vec2d, 3>& triangle) {
    const Vec2d legs{triangle[1].x - triangle[0].x, triangle[2].y - triangle[0].y};
    const Vec2d size = glm::abs(legs);
    const double inner_radius = 0.5 * (size.x + size.y - std::hypot(size.x, size.y));
    const Vec2d centre = triangle[0] + inner_radius * glm::sign(legs);
    const double keep = 1.0 - pull_in_texels / inner_radius;
    std::array<Vec2d, 3> moved;
    for (std::size_t k = 0; k < 3; ++k) moved[k] = centre + keep * (triangle[k] - centre);
    return moved;
}

BlockCorners upright_corners(const Block& block, Overscan mode, bool joins_right) {
    const Vec2d legs{block.leg_x, block.leg_y};
    Vec2d low{block.x + block.gutter, block.y + block.gutter};
    if (mode == Overscan::bilinear) {
        low += Vec2d{block.joins_left ? -0.5 : 0.5, 0.5};
        return right_triangles(low, low + legs, block.overscan);
    }
    Vec2d high = low + legs;
    if (block.shares_hypotenuse) {
        low += pull_in_texels * Vec2d{block.joins_left ? 0.0 : 1.0, 1.0};
        high -= pull_in_texels * Vec2d{joins_right ? 0.0 : 1.0, 1.0};
        return right_triangles(low, high, 0.0);
    }
    BlockCorners corners = right_triangles(low, high, block.overscan);
    corners.lower = pulled_in(corners.lower);
    corners.upper = pulled_in(corners.upper);
    return corners;
}

/// Corners of a collapsed block, spread by half a texel to either side across the direction in
/// which it is one texel wide, so that the texels lie on the middle line of what the block shows.
BlockCorners spread_corners(const Block& block) {
    const Vec2d middle{block.x + 0.5, block.y + 0.5};
    const Vec2d thin{block.leg_x == 0 ? 1.0 : 0.0, block.leg_y == 0 ? 1.0 : 0.0};
    const Vec2d legs = Vec2d{block.leg_x, block.leg_y} + thin;
    if (block.upper >= 0) {
        const Vec2d low = middle - 0.5 * thin;
        return right_triangles(low, low + legs, 0.0);
    }
    // A single's middle is its median, or in a block of one texel its centroid.
    if (block.leg_x == 0 && block.leg_y == 0)
        return right_triangles(middle - 1.0 / 3.0, middle + 2.0 / 3.0, 0.0);
    const Vec2d half = 0.5 * thin;
    if (block.leg_x == 0)
        return {{middle - half, middle + half, middle + Vec2d{0, block.leg_y}}, {}};
    return {{middle - half, middle + Vec2d{block.leg_x, 0}, middle + half}, {}};
}

BlockCorners mirrored(const BlockCorners& corners, const Block& block) {
    const auto mirror = [&block](const Vec2d& c) {
        return Vec2d{2.0 * block.x + block.width - c.x, c.y};
    };
    const auto& [l, u] = corners;
    return {{mirror(l[0]), mirror(l[2]), mirror(l[1])}, {mirror(u[0]), mirror(u[2]), mirror(u[1])}};
}

}  // namespace

BlockCorners block_corners(const Block& block, Overscan mode, bool joins_right) {
    if (block.shares_texel) {
        const Vec2d middle{block.x + 0.5, block.y + 0.5};
        return {{middle, middle, middle}, {middle, middle, middle}};
    }
    const BlockCorners corners = upright_corners(block, mode, joins_right);
    return block.rising ? mirrored(corners, block) : corners;
}

BlockCorners sampled_corners(const Block& block) {
    const BlockCorners corners = spread_corners(block);
    return block.rising ? mirrored(corners, block) : corners;
}

}  // namespace burl
