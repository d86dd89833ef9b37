// Overscan counts and texel ownership in integers, after Carr & Hart 2001, section 4.1; the
// derivations are in docs/reference/atlases.md.
#include "atlas/solid/overscan.h"

#include <algorithm>
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

}  // namespace burl
