#include "atlas/outline/outline_mask.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace burl {
namespace {

/// Half of the gutter between two charts, in cells.
constexpr double half_gutter = 0.25;
constexpr std::uint64_t all_cells = ~std::uint64_t(0);

/// Sets the cells [first, last] of a row.
void set_cells(GridRow& row, std::uint32_t first, std::uint32_t last) {
    if (first < 64)
        row.low |= (all_cells << first) & (last < 63 ? ~(all_cells << (last + 1)) : all_cells);
    if (last < 64) return;
    row.high |= (first < 64 ? all_cells : all_cells << (first - 64)) &
                (last < 127 ? ~(all_cells << (last - 63)) : all_cells);
}

/// Appends the runs of set cells of a row.
void append_runs(GridRow row, std::vector<CellRun>& runs) {
    for (std::uint32_t at = 0; at < most_cells;) {
        const GridRow free{~row.low, ~row.high};
        const std::uint32_t skipped = free.leading();
        if (skipped == most_cells) return;
        row = row.moved_down(skipped);
        const std::uint32_t count = row.leading();
        runs.push_back({at + skipped, count});
        if (count == most_cells) return;
        row = row.moved_down(count);
        at += skipped + count;
    }
}

void find_runs(std::span<const GridRow> rows, OutlineMask& mask) {
    mask.begin.assign(1, 0);
    for (std::uint32_t y = 0; y < mask.height; ++y) {
        append_runs(rows[y], mask.runs);
        mask.begin.push_back(std::uint32_t(mask.runs.size()));
    }
}

/// Sets all that follows from the runs.
void weigh(OutlineMask& mask) {
    double sum = 0.0, count = 0.0;
    std::uint32_t longest = 0;
    for (std::uint32_t y = 0; y < mask.height; ++y)
        for (const CellRun& run : mask.row(y)) {
            sum += (y + 0.5) * run.count;
            count += run.count;
            if (run.count > longest) mask.fullest = y;
            longest = std::max(longest, run.count);
        }
    mask.weight_y = sum / std::max(count, 1.0);
}

/// Sets the runs of `mask` to those of the other one after a quarter turn.
void turn_once(const OutlineMask& other, OutlineMask& mask) {
    std::array<GridRow, most_cells> rows{};
    for (std::uint32_t y = 0; y < other.height; ++y)
        for (const CellRun& run : other.row(y))
            for (std::uint32_t x = run.first; x < run.first + run.count; ++x)
                rows[x].set(other.height - 1 - y);
    find_runs(rows, mask);
}

/// Sets the runs of `mask` to those of the other one after half a turn.
void turn_twice(const OutlineMask& other, OutlineMask& mask) {
    mask.begin.assign(1, 0);
    for (std::uint32_t y = mask.height; y-- > 0;) {
        const auto row = other.row(y);
        for (std::size_t i = row.size(); i-- > 0;)
            mask.runs.push_back({mask.width - row[i].first - row[i].count, row[i].count});
        mask.begin.push_back(std::uint32_t(mask.runs.size()));
    }
}

std::uint32_t cells_round(double size) {
    return std::uint32_t(std::min(std::floor(size + 2.0 * half_gutter), double(most_cells))) + 1;
}

/// The place after another quarter turn, (x, y) to (height - y, x).
PackedOutline turned(const PackedOutline& p, double height) {
    const auto turn = [](const Vec2d& v) { return Vec2d(-v.y, v.x); };
    return {turn(p.column_x), turn(p.column_y), turn(p.origin) + Vec2d(height, 0.0)};
}

/// The cell of a place along a side of `side` cells. Places are not below 0, but for rounding.
std::uint32_t cell_of(double at, std::uint32_t side) {
    return std::uint32_t(std::clamp(int(at), 0, int(side) - 1));
}

/// The first cell whose centre is not below a place.
std::uint32_t first_centre(double at) {
    const double from = at - 0.5;
    if (!(from > 0.0)) return 0;
    const auto whole = std::uint32_t(from);
    return whole + (double(whole) < from ? 1 : 0);
}

}  // namespace

std::uint32_t GridRow::leading() const {
    return std::uint32_t(low != all_cells ? std::countr_one(low) : 64 + std::countr_one(high));
}

TurnedMasks MaskMaker::operator()(const Outline& outline) {
    TurnedMasks turns;
    Vec2d low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec2d& q : outline.points) {
        low = glm::min(low, q);
        high = glm::max(high, q);
    }
    const Vec2d size = scale_ / double(cell_) * (high - low);
    width_ = cells_round(size.x), height_ = cells_round(size.y);
    for (std::size_t q = 0; q < 4; ++q) {
        turns[q].width = q % 2 == 0 ? width_ : height_;
        turns[q].height = q % 2 == 0 ? height_ : width_;
    }
    if (std::max(width_, height_) > most_cells) return turns;
    turns[0].placed = {Vec2d(scale_, 0.0), Vec2d(0.0, scale_),
                       Vec2d(half_gutter * double(cell_)) - scale_ * low};
    points_.clear();
    for (const Vec2d& q : outline.points) points_.push_back(turns[0].placed(q) / double(cell_));
    rows_.fill(GridRow{});
    draw_inside();
    draw_border();
    find_runs(rows_, turns[0]);
    turn_once(turns[0], turns[1]);
    turn_twice(turns[0], turns[2]);
    turn_twice(turns[1], turns[3]);
    for (std::size_t q = 1; q < 4; ++q)
        turns[q].placed = turned(turns[q - 1].placed, double(cell_ * turns[q - 1].height));
    for (OutlineMask& mask : turns) weigh(mask);
    return turns;
}

/// Marks the cells whose centres lie inside.
void MaskMaker::draw_inside() {
    crossings_.resize(std::max<std::size_t>(crossings_.size(), height_));
    for (std::vector<double>& row : crossings_) row.clear();
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Vec2d &a = points_[i], &b = points_[i + 1 < points_.size() ? i + 1 : 0];
        const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
        for (std::uint32_t y = first_centre(low); y < height_ && y + 0.5 < high; ++y)
            crossings_[y].push_back(a.x + (y + 0.5 - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    for (std::uint32_t y = 0; y < height_; ++y) {
        std::vector<double>& row = crossings_[y];
        std::ranges::sort(row);
        for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
            const std::uint32_t first = first_centre(row[i]);
            const std::uint32_t end = std::min(first_centre(row[i + 1]), width_);
            if (first < end) set_cells(rows_[y], first, end - 1);
        }
    }
}

/// Marks the cells that half a gutter round the border touches.
void MaskMaker::draw_border() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Vec2d &a = points_[i], &b = points_[i + 1 < points_.size() ? i + 1 : 0];
        const int steps = int(4.0 * glm::distance(a, b)) + 1;
        for (int s = 0; s < steps; ++s) {
            const Vec2d q = a + double(s) / steps * (b - a);
            const std::uint32_t x0 = cell_of(q.x - half_gutter, width_),
                                x1 = cell_of(q.x + half_gutter, width_),
                                y1 = cell_of(q.y + half_gutter, height_);
            for (std::uint32_t y = cell_of(q.y - half_gutter, height_); y <= y1; ++y)
                set_cells(rows_[y], x0, x1);
        }
    }
}

}  // namespace burl
