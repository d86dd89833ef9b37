// Overscan counts and ownership against the definition: which texels a lookup can read.
#include "atlas/solid/block.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace burl {
namespace {

/// Whether a lookup somewhere in the closed triangle (0,0), (sx,0), (0,sy) reads texel (i,j).
/// Bilinear: texel centres are the integers and the filter's support is the open box of 2 x 2.
/// Nearest: texel (i,j) is the half-open unit box, the triangle is open (corners are pulled in).
bool reads(Overscan mode, int sx, int sy, int i, int j) {
    if (i < 0 || j < 0) return false;
    if (mode == Overscan::nearest) return i * sy + j * sx < sx * sy;
    if (i > sx || j > sy) return false;
    if (i == 0 && j == 0) return true;
    const int x = std::max(0, i - 1), y = std::max(0, j - 1);
    return x * sy + y * sx < sx * sy;
}

Block block_of(Overscan mode, std::uint32_t sx, std::uint32_t sy, std::uint32_t columns) {
    Block block;
    block.lower = 0;
    block.upper = 1;
    block.leg_x = sx;
    block.leg_y = sy;
    block.overscan = columns;
    block.width = sx + border_texels(mode) + columns;
    block.height = sy + border_texels(mode);
    return block;
}

/// Whether the block's ownership gives each triangle every texel it can read.
bool separates(Overscan mode, const Block& block) {
    const int sx = int(block.leg_x), sy = int(block.leg_y), k = int(block.overscan);
    const int last_row = int(block.height) - 1, last_column = int(block.width) - 1 - k;
    for (int j = 0; j <= last_row; ++j)
        for (int i = 0; i < int(block.width); ++i) {
            const bool lower = std::uint32_t(i) < split(block, mode, std::uint32_t(j));
            if (!lower && reads(mode, sx, sy, i, j)) return false;
            if (lower && reads(mode, sx, sy, last_column - (i - k), last_row - j)) return false;
        }
    return true;
}

/// Whether any texel is read from both triangles.
bool both_read_some(Overscan mode, int sx, int sy, int k) {
    const int b = int(border_texels(mode));
    for (int j = 0; j < sy + b; ++j)
        for (int i = 0; i < sx + b + k; ++i)
            if (reads(mode, sx, sy, i, j) &&
                reads(mode, sx, sy, sx + b - 1 + k - i, sy + b - 1 - j))
                return true;
    return false;
}

class OverscanTest : public testing::TestWithParam<Overscan> {};

TEST_P(OverscanTest, ColumnsAreTheFewestThatSeparateTheTriangles) {
    for (int sy = 1; sy <= 24; ++sy)
        for (int sx = 1; sx <= 40; ++sx) {
            const auto k = int(overscan_columns(GetParam(), std::uint32_t(sx), std::uint32_t(sy)));
            EXPECT_FALSE(both_read_some(GetParam(), sx, sy, k)) << sx << " x " << sy;
            EXPECT_TRUE(both_read_some(GetParam(), sx, sy, k - 1)) << sx << " x " << sy;
        }
}

TEST_P(OverscanTest, SplitGivesEachTriangleWhatItReads) {
    for (std::uint32_t sy = 1; sy <= 20; ++sy)
        for (std::uint32_t sx = 1; sx <= 31; ++sx)
            for (std::uint32_t more : {0u, 1u, 5u}) {
                const std::uint32_t k = overscan_columns(GetParam(), sx, sy) + more;
                EXPECT_TRUE(separates(GetParam(), block_of(GetParam(), sx, sy, k)))
                    << sx << " x " << sy << " with " << k;
            }
}

TEST_P(OverscanTest, LongestLegFitsAndTheNextDoesNot) {
    const std::uint32_t border = border_texels(GetParam());
    const auto width = [&](std::uint32_t sx, std::uint32_t sy) {
        return sx + border + overscan_columns(GetParam(), sx, sy);
    };
    for (std::uint32_t sy = 1; sy <= 30; ++sy)
        for (std::uint32_t w = width(1, sy); w <= 150; ++w) {
            const std::uint32_t leg = longest_leg(GetParam(), w, sy);
            EXPECT_LE(width(leg, sy), w);
            for (std::uint32_t longer = leg + 1; longer <= w; ++longer)
                ASSERT_GT(width(longer, sy), w) << longer << " x " << sy;
        }
}

INSTANTIATE_TEST_SUITE_P(Modes, OverscanTest,
                         testing::Values(Overscan::nearest, Overscan::bilinear));

TEST(Overscan, EqualLegsNeedThePapersOneColumnForNearestAndThreeForBilinear) {
    for (std::uint32_t leg : {2u, 3u, 10u, 101u}) {
        EXPECT_EQ(overscan_columns(Overscan::nearest, leg, leg), 1u);
        EXPECT_EQ(overscan_columns(Overscan::bilinear, leg, leg), 3u);
    }
}

TEST(Overscan, SharedDiagonalSplitsAtTheTexelCentreAndTheDiagonalIsLowers) {
    for (std::uint32_t sy = 1; sy <= 17; ++sy)
        for (std::uint32_t sx = 1; sx <= 23; ++sx)
            for (const Overscan mode : {Overscan::nearest, Overscan::bilinear}) {
                Block block = block_of(mode, sx, sy, 0);
                block.shares_hypotenuse = true;
                const double half = mode == Overscan::nearest ? 0.5 : 0.0;
                for (std::uint32_t j = 0; j < block.height; ++j)
                    for (std::uint32_t i = 0; i < block.width; ++i) {
                        // Twice the coordinates, so that everything is a whole number.
                        const double side = (2 * (i + half)) * sy + (2 * (j + half)) * sx;
                        EXPECT_EQ(i < split(block, mode, j), side <= 2.0 * sx * sy);
                    }
            }
}

}  // namespace
}  // namespace burl
