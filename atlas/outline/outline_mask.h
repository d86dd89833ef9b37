#pragma once
// The cells of a grid that an outline and half a gutter round it touch, in its four quarter turns,
// as runs of cells row by row.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/outline/pack.h"

namespace burl {

inline constexpr std::uint32_t most_cells = 128;  ///< largest side of a grid, in cells

/// A row of a grid, one bit a cell.
struct GridRow {
    std::uint64_t low = 0, high = 0;  ///< the first 64 cells, and those beyond

    friend GridRow operator|(const GridRow& a, const GridRow& b) {
        return {a.low | b.low, a.high | b.high};
    }
    bool full() const { return (low & high) == ~std::uint64_t(0); }
    /// The row moved by fewer than 128 cells towards the first.
    GridRow moved_down(std::uint32_t by) const {
        const std::uint32_t bits = by % 64;
        if (by >= 64) return {high >> bits, 0};
        return {low >> bits | (high << 1 << (63 - bits)), high >> bits};
    }
    void set(std::uint32_t cell) { (cell < 64 ? low : high) |= std::uint64_t(1) << cell % 64; }
    /// Number of set cells before the first free one.
    std::uint32_t leading() const;
};

/// Cells [first, first + count) of a row.
struct CellRun {
    std::uint32_t first, count;
};

/// The cells of a turned and scaled outline.
struct OutlineMask {
    std::uint32_t width = 0, height = 0;
    std::vector<CellRun> runs;         ///< runs of all rows
    std::vector<std::uint32_t> begin;  ///< height + 1 offsets into runs
    std::uint32_t fullest = 0;         ///< the row with the longest run
    double weight_y = 0.0;             ///< mean row of the cells
    PackedOutline placed;              ///< place of the outline with the mask at cell (0, 0)

    std::span<const CellRun> row(std::uint32_t y) const {
        return std::span(runs).subspan(begin[y], begin[y + 1] - begin[y]);
    }
};

/// The masks of an outline in its four quarter turns.
using TurnedMasks = std::array<OutlineMask, 4>;

/// Draws outlines into masks at one scale.
class MaskMaker {
  public:
    /// The scale is in texels per unit of the outlines, cells are of `cell` texels a side.
    MaskMaker(double scale, std::uint32_t cell) : scale_(scale), cell_(cell) {}

    /// The masks of an outline, those of the turns being the first one turned. Where a side is
    /// longer than `most_cells`, they have sides, but no runs.
    TurnedMasks operator()(const Outline& outline);

  private:
    void draw_inside();
    void draw_border();

    double scale_;
    std::uint32_t cell_;
    std::uint32_t width_ = 0, height_ = 0;        ///< of the mask, in cells
    std::vector<Vec2d> points_;                   ///< corners, in cells
    std::array<GridRow, most_cells> rows_;        ///< the mask
    std::vector<std::vector<double>> crossings_;  ///< of each row, kept for its memory
};

}  // namespace burl
