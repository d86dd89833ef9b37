// Overscan counts and texel owners in integers, and places of corners, after Carr & Hart 2001,
// section 4.1 and figure 4; the derivations are in docs/reference/atlases.md.
#include "atlas/solid/block.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burl {

namespace {

// Overscan columns for bilinear lookups. With legs (sx, sy) = g (p, q), a lookup in `lower` reads
// texel (i,j) iff i <= sx and i sy + j sx < sx sy + sx + sy; `upper` reads the same set turned by
// 180 degrees. The two largest counts of a row meet in some row unless g = 1 and q divides p - 1.
std::uint32_t bilinear_columns(std::uint32_t leg_x, std::uint32_t leg_y) {
    if (leg_y == 1) return leg_x + 1;
    const std::uint32_t g = std::gcd(leg_x, leg_y), p = leg_x / g, q = leg_y / g;
    const bool rows_miss = g == 1 && (p - 1) % q == 0;
    return 3 + 2 * (p - 1) / q - (rows_miss ? 1 : 0);
}

// Overscan columns for nearest lookups: one in `lower` reads texel (i,j) iff i sy + j sx < sx sy.
std::uint32_t nearest_columns(std::uint32_t leg_x, std::uint32_t leg_y) {
    const std::uint32_t g = std::gcd(leg_x, leg_y), p = leg_x / g, q = leg_y / g;
    return 1 + (p - 1 + q - 1) / q;
}

/// Columns of row j that `lower` owns in a block one texel wide or high, whose texels lie on the
/// middle line across both triangles.
std::int64_t collapsed_columns(const Block& block, std::int64_t j) {
    if (!block.shares_hypotenuse) return block.width;
    if (block.leg_y == 0) return std::int64_t{block.leg_x} / 2 + 1;
    return 2 * j <= std::int64_t{block.leg_y} ? 1 : 0;
}

std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

/// Columns of row j that `lower` owns in a bilinear block with a gutter, counted from the block's
/// side. The diagonal goes on through the gutter, and so does a single triangle, which leaves as
/// much beyond its hypotenuse.
std::int64_t gutter_columns(const Block& block, std::int64_t j) {
    const std::int64_t sx = block.leg_x, sy = block.leg_y, g = block.gutter;
    if (block.shares_hypotenuse) return g + floor_divide(sx * (sy - (j - g)), sy) + 1;
    if (block.overscan > 0) {
        const std::int64_t row = std::clamp<std::int64_t>(j - g, 0, sy);
        return g + std::min(sx, (sx * sy + sx + sy - row * sx - 1) / sy) + 1;
    }
    const std::int64_t beyond = (1 + g) * (sx + sy);
    return g + std::min(sx + g, floor_divide(sx * sy + beyond - (j - g) * sx - 1, sy)) + 1;
}

/// Columns of row j that `lower` owns, counted from the texel at the right angle.
std::int64_t lower_columns(const Block& block, Overscan mode, std::int64_t j) {
    const std::int64_t sx = block.leg_x, sy = block.leg_y;
    if (block.collapsed()) return collapsed_columns(block, j);
    if (block.gutter > 0) return gutter_columns(block, j);
    if (mode == Overscan::bilinear) {
        if (block.shares_hypotenuse) return sx * (sy - j) / sy + 1;
        return std::min(sx, (sx * sy + sx + sy - j * sx - 1) / sy) + 1;
    }
    if (block.shares_hypotenuse) return ((2 * sy - 2 * j - 1) * sx / sy + 1) / 2;
    return (sx * (sy - j) + sy - 1) / sy;
}

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

BlockCorners lookup_corners(const Block& block, Overscan mode, bool joins_right) {
    if (block.shares_texel) {
        const Vec2d middle{block.x + 0.5, block.y + 0.5};
        return {{middle, middle, middle}, {middle, middle, middle}};
    }
    const BlockCorners corners = upright_corners(block, mode, joins_right);
    return block.rising ? mirrored(corners, block) : corners;
}

}  // namespace

std::uint32_t border_texels(Overscan mode) {
    return mode == Overscan::bilinear ? 1 : 0;
}

std::uint32_t overscan_columns(Overscan mode, std::uint32_t leg_x, std::uint32_t leg_y) {
    return mode == Overscan::bilinear ? bilinear_columns(leg_x, leg_y)
                                      : nearest_columns(leg_x, leg_y);
}

std::uint32_t longest_leg(Overscan mode, std::uint32_t width, std::uint32_t leg_y) {
    const std::uint32_t border = border_texels(mode);
    // Start at an upper bound: the columns are more than slope * leg_x / leg_y - 1.
    const std::uint64_t slope = mode == Overscan::bilinear && leg_y > 1 ? 2 : 1;
    const std::uint64_t room = width - border + std::uint64_t{1};
    auto leg = static_cast<std::uint32_t>(room * leg_y / (leg_y + slope) + 1);
    while (leg > 1 && leg + border + overscan_columns(mode, leg, leg_y) > width) --leg;
    return leg;
}

std::uint32_t split(const Block& block, Overscan mode, std::uint32_t j) {
    if (block.upper < 0 && !block.fills_up) return block.width;
    // A joined bilinear block starts one texel right of its triangles' common edge.
    const bool starts_late = block.joins_left && mode == Overscan::bilinear;
    const std::int64_t columns = lower_columns(block, mode, j) - (starts_late ? 1 : 0);
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(columns, 0, block.width));
}

void place_corners(Atlas& atlas, const Block& block, bool joins_right) {
    const BlockCorners places = lookup_corners(block, atlas.options.overscan, joins_right);
    const auto place = [&](std::int32_t triangle, std::size_t first,
                           const std::array<Vec2d, 3>& corners) {
        for (std::size_t k = 0; k < 3; ++k)
            atlas.corners[std::size_t(triangle)][(first + k) % 3] = corners[k];
    };
    place(block.lower, block.lower_corner, places.lower);
    if (block.upper >= 0) place(block.upper, block.upper_corner, places.upper);
}

BlockCorners sampled_corners(const Block& block) {
    const BlockCorners corners = spread_corners(block);
    return block.rising ? mirrored(corners, block) : corners;
}

}  // namespace burl
