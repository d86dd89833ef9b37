// Masks that are moved apart share no cell, stay in the grid, and end where no single move of a
// cell leads them farther from what their borders read of each other, by its definition.
#include "atlas/outline/spread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace burl {
namespace {

using Cells = std::set<std::pair<int, int>>;

/// The mask of an outline, drawn with cells of one unit.
OutlineMask mask_of(const std::vector<Vec2d>& points) {
    return MaskMaker(1.0, 1)(Outline{points, 1.0})[0];
}

OutlineMask rectangle(double width, double height) {
    // Half a gutter, a quarter of a cell, is left on every side.
    return mask_of({{0, 0}, {width - 0.6, 0}, {width - 0.6, height - 0.6}, {0, height - 0.6}});
}

OutlineMask star(std::mt19937& random) {
    std::uniform_real_distribution<double> any(2.0, 7.0);
    std::vector<Vec2d> points;
    for (int k = 0; k < 9; ++k) {
        const double a = std::numbers::pi * k / 4.5, r = any(random);
        points.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    return mask_of(points);
}

Cells cells_of(const PlacedMask& placed) {
    Cells cells;
    for (std::uint32_t y = 0; y < placed.mask->height; ++y)
        for (const CellRun& run : placed.mask->row(y))
            for (std::uint32_t x = run.first; x < run.first + run.count; ++x)
                cells.emplace(int(placed.x + x), int(placed.y + y));
    return cells;
}

bool share_a_cell(const Cells& a, const Cells& b) {
    return std::ranges::any_of(a, [&](const auto& cell) { return b.contains(cell); });
}

/// The product of two boxes of five cells whose middles are d cells apart.
double tent(int d) {
    return std::max(0, 5 - std::abs(d));
}

/// The border of one outline reads this of another's cells.
double reads(const Cells& one, const Cells& other) {
    double sum = 0.0;
    for (const auto& [x, y] : one) {
        if (one.contains({x - 1, y}) && one.contains({x + 1, y}) && one.contains({x, y - 1}) &&
            one.contains({x, y + 1}))
            continue;
        for (const auto& [u, v] : other) sum += tent(u - x) * tent(v - y);
    }
    return sum;
}

double reads_of_others(const std::vector<Cells>& all, std::size_t i, const Cells& cells) {
    double sum = 0.0;
    for (std::size_t j = 0; j < all.size(); ++j)
        if (j != i) sum += reads(cells, all[j]);
    return sum;
}

TEST(SpreadMasks, TwoThatTouchMoveOutOfEachOthersReach) {
    const OutlineMask square = rectangle(4, 4);
    ASSERT_EQ(square.width, 4u);
    std::vector<PlacedMask> masks{{&square, 10, 12}, {&square, 14, 12}};
    spread_masks(masks, 32);
    EXPECT_EQ(reads(cells_of(masks[0]), cells_of(masks[1])), 0.0);
}

TEST(SpreadMasks, OneBetweenTwoWallsEndsHalfWay) {
    const OutlineMask wall = rectangle(4, 18), square = rectangle(4, 4);
    std::vector<PlacedMask> masks{{&wall, 0, 0}, {&square, 4, 5}, {&wall, 14, 0}};
    spread_masks(masks, 18);
    EXPECT_EQ(masks[0].x, 0u);
    EXPECT_EQ(masks[2].x, 14u);
    EXPECT_EQ(masks[1].x, 7u);
}

TEST(SpreadMasks, AFullGridStaysAsItIs) {
    const OutlineMask half = rectangle(8, 16);
    std::vector<PlacedMask> masks{{&half, 0, 0}, {&half, 8, 0}};
    spread_masks(masks, 16);
    EXPECT_EQ(masks[0].x, 0u);
    EXPECT_EQ(masks[1].x, 8u);
}

/// Stars in a grid of 48 cells a side, each where it touches none of those before.
struct Stars {
    std::vector<OutlineMask> drawn;
    std::vector<PlacedMask> masks;

    explicit Stars(std::uint32_t seed) {
        std::mt19937 random(seed);
        for (int i = 0; i < 8; ++i) drawn.push_back(star(random));
        std::vector<Cells> taken;
        for (const OutlineMask& mask : drawn)
            for (std::uint32_t at = 0; at < 48 * 48; ++at) {
                const PlacedMask placed{&mask, at % 48, at / 48};
                if (placed.x + mask.width > 48 || placed.y + mask.height > 48) continue;
                Cells cells = cells_of(placed);
                if (std::ranges::any_of(taken, [&](auto& t) { return share_a_cell(t, cells); }))
                    continue;
                taken.push_back(std::move(cells));
                masks.push_back(placed);
                break;
            }
    }

    std::vector<Cells> cells() const {
        std::vector<Cells> result;
        for (const PlacedMask& mask : masks) result.push_back(cells_of(mask));
        return result;
    }
};

TEST(SpreadMasks, BordersReadLessThanBefore) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        Stars stars(seed);
        ASSERT_EQ(stars.masks.size(), 8u);
        const std::vector<Cells> before = stars.cells();
        spread_masks(stars.masks, 48);
        const std::vector<Cells> after = stars.cells();
        double read_before = 0.0, read_after = 0.0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(share_a_cell(after[i], after[j]));
            for (const auto& [x, y] : after[i]) EXPECT_TRUE(x < 48 && y < 48);
            read_before += reads_of_others(before, i, before[i]);
            read_after += reads_of_others(after, i, after[i]);
        }
        EXPECT_LT(read_after, 0.6 * read_before) << seed;
    }
}

TEST(SpreadMasks, NoMoveOfACellIsLeftThatReadsLess) {
    Stars stars(4);
    spread_masks(stars.masks, 48);
    const std::vector<Cells> all = stars.cells();
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
            PlacedMask moved = stars.masks[i];
            if ((moved.x == 0 && dx < 0) || (moved.y == 0 && dy < 0)) continue;
            moved.x = std::uint32_t(int(moved.x) + dx);
            moved.y = std::uint32_t(int(moved.y) + dy);
            if (moved.x + moved.mask->width > 48 || moved.y + moved.mask->height > 48) continue;
            const Cells cells = cells_of(moved);
            bool is_free = true;
            for (std::size_t j = 0; j < all.size(); ++j)
                is_free = is_free && (j == i || !share_a_cell(cells, all[j]));
            if (!is_free) continue;
            EXPECT_GE(reads_of_others(all, i, cells), reads_of_others(all, i, all[i]));
        }
}

}  // namespace
}  // namespace burl
