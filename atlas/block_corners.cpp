// Corner positions for both overscans (Carr & Hart 2001, section 4.1, figure 4).
#include "atlas/block_corners.h"

#include <cmath>

namespace burl {

namespace {

// Graphics hardware snaps vertices to 1/256 pixel and then extrapolates the texture coordinate to
// the pixel's centre: where n texels meet a pixel a lookup can leave its triangle by n/256 texel.
// This covers 8 texels a pixel.
constexpr double pull_in_texels = 1.0 / 32.0;

BlockCorners right_triangles(const Vec2d& low, const Vec2d& high, double shift) {
    return {{low, Vec2d{high.x, low.y}, Vec2d{low.x, high.y}},
            {Vec2d{high.x + shift, high.y}, Vec2d{low.x + shift, high.y},
             Vec2d{high.x + shift, low.y}}};
}

/// Moves the three edges of a right triangle (right angle first) in by the same distance.
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

}  // namespace

BlockCorners block_corners(const Block& block, Overscan mode, bool joins_right) {
    const Vec2d legs{block.leg_x, block.leg_y};
    Vec2d low{block.x, block.y};
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

}  // namespace burl
