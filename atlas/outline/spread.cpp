// What a border cell reads of the others is the sum of their cells blurred by a tent, the product
// of two boxes: what a bilinear lookup reads in a level whose texels are as wide as the boxes.
// Outlines take turns: each moves to the place, up to `farthest` cells away, where the sum over its
// border is least, until none moves.
#include "atlas/outline/spread.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace burl {
namespace {

/// Integers, so that what one outline adds it takes away again exactly.
using Weight = std::int64_t;

/// Cells of the tent's boxes on either side of their middle. Boxes of 3 and 9 cells, and sums of
/// three tents, lead to the same errors.
constexpr int radius = 2;
constexpr int reach = 2 * radius;  ///< of the tent, in cells
/// Weight of a taken cell itself, above what a border as long as a grid has cells could read.
constexpr Weight taken = Weight(1) << 40;

constexpr int farthest = 6;      ///< cells that an outline moves at a time, along either side
constexpr int most_sweeps = 16;  ///< moves of each outline; most grids are done after 3 to 5

/// A cell of a mask, from its low corner.
struct Cell {
    int x, y;
};

/// Weights of a rectangle of cells with `reach` more on every side.
struct Sheet {
    int width, height;  ///< with what is beyond the rectangle
    std::vector<Weight> weights;

    Sheet(std::uint32_t columns, std::uint32_t rows)
        : width(int(columns) + 2 * reach),
          height(int(rows) + 2 * reach),
          weights(std::size_t(width) * std::size_t(height), 0) {}

    Weight* row(int y) { return weights.data() + std::ptrdiff_t(y) * width; }
    const Weight* row(int y) const { return weights.data() + std::ptrdiff_t(y) * width; }
    /// The weight at cell (x, y) of the rectangle.
    Weight& at(int x, int y) { return row(y + reach)[x + reach]; }
    Weight at(int x, int y) const { return row(y + reach)[x + reach]; }
};

/// Replaces each of `count` weights, `stride` apart, by the sum of those up to `radius` away;
/// `before` is kept for its memory.
void sum_along(Weight* first, int count, std::ptrdiff_t stride, std::vector<Weight>& before) {
    before.assign(1, 0);
    for (int i = 0; i < count; ++i) before.push_back(before.back() + first[i * stride]);
    for (int i = 0; i < count; ++i)
        first[i * stride] = before[std::size_t(std::min(i + radius + 1, count))] -
                            before[std::size_t(std::max(i - radius, 0))];
}

/// Blurs by the tent.
void blur(Sheet& sheet) {
    std::vector<Weight> before;
    for (int times = 0; times < 2; ++times) {
        for (int y = 0; y < sheet.height; ++y) sum_along(sheet.row(y), sheet.width, 1, before);
        for (int x = 0; x < sheet.width; ++x)
            sum_along(sheet.row(0) + x, sheet.height, sheet.width, before);
    }
}

/// An outline on its way.
struct Moving {
    std::vector<Cell> cells, border;  ///< border: cells with a free one beside them
    Sheet weights;                    ///< what it adds to the grid round it
    int x, y;                         ///< cell of its low corner
};

Moving moving(const PlacedMask& placed) {
    const OutlineMask& mask = *placed.mask;
    Moving result{{}, {}, Sheet(mask.width, mask.height), int(placed.x), int(placed.y)};
    Sheet& alone = result.weights;
    for (std::uint32_t y = 0; y < mask.height; ++y)
        for (const CellRun& run : mask.row(y))
            for (std::uint32_t x = run.first; x < run.first + run.count; ++x) {
                result.cells.push_back({int(x), int(y)});
                alone.at(int(x), int(y)) = 1;
            }
    for (const auto& [x, y] : result.cells)
        if (alone.at(x - 1, y) + alone.at(x + 1, y) + alone.at(x, y - 1) + alone.at(x, y + 1) < 4)
            result.border.push_back({x, y});
    blur(result.weights);
    for (const auto& [x, y] : result.cells) result.weights.at(x, y) += taken;
    return result;
}

/// The grid with the weights of all outlines.
class Room {
  public:
    explicit Room(std::uint32_t side) : sum_(side, side) {}

    void add(const Moving& outline, Weight times) {
        for (int y = 0; y < outline.weights.height; ++y) {
            Weight* to = sum_.row(outline.y + y) + outline.x;
            const Weight* from = outline.weights.row(y);
            for (int x = 0; x < outline.weights.width; ++x) to[x] += times * from[x];
        }
    }

    /// Moves an outline that the grid does not hold; whether it has moved.
    bool move(Moving& outline) const {
        const int from_x = outline.x, from_y = outline.y;
        Weight least = read(outline, from_x, from_y, std::numeric_limits<Weight>::max());
        for (int y = from_y - farthest; y <= from_y + farthest; ++y)
            for (int x = from_x - farthest; x <= from_x + farthest; ++x) {
                if (!is_inside(outline, x, y)) continue;
                const Weight here = read(outline, x, y, least);
                if (here >= least || !is_free(outline, x, y)) continue;
                least = here;
                outline.x = x;
                outline.y = y;
            }
        return outline.x != from_x || outline.y != from_y;
    }

  private:
    bool is_inside(const Moving& outline, int x, int y) const {
        return x >= 0 && y >= 0 && x + outline.weights.width <= sum_.width &&
               y + outline.weights.height <= sum_.height;
    }

    /// The outline's border reads this of the others with its low corner at a cell, or `enough`.
    Weight read(const Moving& outline, int x, int y, Weight enough) const {
        Weight sum = 0;
        for (const Cell& cell : outline.border) {
            sum += sum_.at(x + cell.x, y + cell.y);
            if (sum >= enough) return enough;
        }
        return sum;
    }

    bool is_free(const Moving& outline, int x, int y) const {
        return std::ranges::all_of(outline.cells, [&](const Cell& cell) {
            return sum_.at(x + cell.x, y + cell.y) < taken;
        });
    }

    Sheet sum_;
};

}  // namespace

void spread_masks(std::span<PlacedMask> masks, std::uint32_t side) {
    std::vector<Moving> outlines;
    outlines.reserve(masks.size());
    Room room(side);
    for (const PlacedMask& mask : masks) room.add(outlines.emplace_back(moving(mask)), 1);
    bool moved = true;
    for (int sweep = 0; sweep < most_sweeps && moved; ++sweep) {
        moved = false;
        for (Moving& outline : outlines) {
            room.add(outline, -1);
            moved |= room.move(outline);
            room.add(outline, 1);
        }
    }
    for (std::size_t i = 0; i < masks.size(); ++i) {
        masks[i].x = std::uint32_t(outlines[i].x);
        masks[i].y = std::uint32_t(outlines[i].y);
    }
}

}  // namespace burl
