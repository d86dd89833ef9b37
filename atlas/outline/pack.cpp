#include "atlas/outline/pack.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace burl {
namespace {

constexpr std::uint32_t most_cells = 128;  ///< largest side of the grid, in cells
constexpr std::uint32_t words = 2;         ///< words of a row of the grid
/// Half of the gutter between two charts, in cells.
constexpr double half_gutter = 0.25;
/// Ratio between the scales that are tried until one fits, and halvings of the last step.
constexpr double scale_step = 0.96;
constexpr int scale_halvings = 4;
/// Placements of outlines that are spent on trying other orders, and the gain that is wanted of
/// one.
constexpr std::size_t spent_placements = 1200;
constexpr double order_gain = 1.004;

/// A row of the grid, one bit a cell.
using Row = std::array<std::uint64_t, words>;

Row shifted_down(const Row& row, std::uint32_t by) {
    const std::uint32_t skip = by / 64, bits = by % 64;
    Row result{};
    for (std::uint32_t i = 0; i + skip < words; ++i) {
        const std::uint64_t low = row[i + skip],
                            high = i + skip + 1 < words ? row[i + skip + 1] : 0;
        result[i] = bits == 0 ? low : low >> bits | high << (64 - bits);
    }
    return result;
}

Row operator|(const Row& a, const Row& b) {
    return {a[0] | b[0], a[1] | b[1]};
}

/// Cells [first, first + count) of a row.
struct CellRun {
    std::uint32_t first, count;
};

/// The cells of a turned and scaled outline.
struct Mask {
    std::uint32_t width = 0, height = 0;
    std::vector<CellRun> runs;         ///< runs of all rows
    std::vector<std::uint32_t> begin;  ///< height + 1 offsets into runs
    double weight_y = 0.0;             ///< mean row of the cells
    PackedOutline placed;              ///< place of the outline with the mask at cell (0, 0)

    std::span<const CellRun> row(std::uint32_t y) const {
        return std::span(runs).subspan(begin[y], begin[y + 1] - begin[y]);
    }
};

/// The masks of an outline in its four quarter turns.
using Turns = std::array<Mask, 4>;

/// Draws outlines into masks. The masks of its turns are the first mask turned.
class MaskMaker {
  public:
    MaskMaker(double scale, std::uint32_t cell) : scale_(scale), cell_(cell) {}

    Turns operator()(const Outline& outline) {
        Turns turns;
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
        cells_.assign(std::size_t(width_) * height_, 0);
        draw_inside();
        draw_border();
        find_runs(turns[0]);
        for (std::size_t q = 1; q < 4; ++q) {
            turn_cells();
            turns[q].placed = turned(turns[q - 1].placed, double(cell_ * turns[q - 1].height));
            find_runs(turns[q]);
        }
        return turns;
    }

  private:
    static std::uint32_t cells_round(double size) {
        return std::uint32_t(std::min(std::floor(size + 2.0 * half_gutter), double(most_cells))) +
               1;
    }

    /// The place after another quarter turn, (x, y) to (height - y, x).
    static PackedOutline turned(const PackedOutline& p, double height) {
        const auto turn = [](const Vec2d& v) { return Vec2d(-v.y, v.x); };
        return {turn(p.column_x), turn(p.column_y), turn(p.origin) + Vec2d(height, 0.0)};
    }

    void turn_cells() {
        turned_.resize(cells_.size());
        for (std::uint32_t y = 0; y < height_; ++y)
            for (std::uint32_t x = 0; x < width_; ++x)
                turned_[std::size_t(x) * height_ + (height_ - 1 - y)] = cells_[y * width_ + x];
        cells_.swap(turned_);
        std::swap(width_, height_);
    }

    /// Marks the cells whose centres lie inside.
    void draw_inside() {
        std::vector<std::vector<double>> crossings(height_);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const Vec2d &a = points_[i], &b = points_[(i + 1) % points_.size()];
            const auto first = std::uint32_t(std::max(std::ceil(std::min(a.y, b.y) - 0.5), 0.0));
            for (std::uint32_t y = first; y < height_ && y + 0.5 < std::max(a.y, b.y); ++y)
                crossings[y].push_back(a.x + (y + 0.5 - a.y) / (b.y - a.y) * (b.x - a.x));
        }
        for (std::uint32_t y = 0; y < height_; ++y) {
            std::ranges::sort(crossings[y]);
            for (std::size_t i = 0; i + 1 < crossings[y].size(); i += 2)
                for (double x = std::max(std::ceil(crossings[y][i] - 0.5), 0.0);
                     x + 0.5 < crossings[y][i + 1] && x < width_; ++x)
                    cells_[y * width_ + std::size_t(x)] = 1;
        }
    }

    /// Marks the cells that half a gutter round the border touches.
    void draw_border() {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const Vec2d &a = points_[i], &b = points_[(i + 1) % points_.size()];
            const int steps = int(4.0 * glm::distance(a, b)) + 1;
            for (int s = 0; s < steps; ++s) {
                const Vec2d q = a + double(s) / steps * (b - a);
                const auto cell = [&](double at, std::uint32_t side) {
                    return std::uint32_t(std::clamp(std::floor(at), 0.0, side - 1.0));
                };
                const std::uint32_t x1 = cell(q.x + half_gutter, width_);
                const std::uint32_t y1 = cell(q.y + half_gutter, height_);
                for (std::uint32_t y = cell(q.y - half_gutter, height_); y <= y1; ++y)
                    for (std::uint32_t x = cell(q.x - half_gutter, width_); x <= x1; ++x)
                        cells_[y * width_ + x] = 1;
            }
        }
    }

    void find_runs(Mask& mask) const {
        mask.begin.assign(1, 0);
        double sum = 0.0, count = 0.0;
        for (std::uint32_t y = 0; y < mask.height; ++y) {
            for (std::uint32_t x = 0; x < mask.width;) {
                if (cells_[y * mask.width + x] == 0) {
                    ++x;
                    continue;
                }
                const std::uint32_t first = x;
                while (x < mask.width && cells_[y * mask.width + x] != 0) ++x;
                mask.runs.push_back({first, x - first});
                sum += (y + 0.5) * (x - first);
                count += x - first;
            }
            mask.begin.push_back(std::uint32_t(mask.runs.size()));
        }
        mask.weight_y = sum / std::max(count, 1.0);
    }

    double scale_;
    std::uint32_t cell_;
    std::uint32_t width_ = 0, height_ = 0;  ///< of cells_
    std::vector<Vec2d> points_;             ///< corners, in cells
    std::vector<std::uint8_t> cells_, turned_;
};

/// A square of cells, some of which are taken.
class Grid {
  public:
    explicit Grid(std::uint32_t side) : side_(side), rows_(side, Row{}) {}

    /// The lowest free place of the mask (row, then column) with its weight below `most`.
    std::optional<std::array<std::uint32_t, 2>> find(const Mask& mask, double most) const {
        if (mask.width > side_ || mask.height > side_) return std::nullopt;
        for (std::uint32_t y = 0; y + mask.height <= side_ && y + mask.weight_y < most; ++y)
            if (const std::uint32_t x = first_free(mask, y); x + mask.width <= side_)
                return std::array<std::uint32_t, 2>{x, y};
        return std::nullopt;
    }

    void take(const Mask& mask, std::uint32_t x, std::uint32_t y) {
        for (std::uint32_t j = 0; j < mask.height; ++j)
            for (const CellRun& run : mask.row(j))
                for (std::uint32_t c = x + run.first; c < x + run.first + run.count; ++c)
                    rows_[y + j][c / 64] |= std::uint64_t(1) << c % 64;
    }

  private:
    /// The first column where the mask's low corner is free in row y, or the grid's end.
    std::uint32_t first_free(const Mask& mask, std::uint32_t y) const {
        Row blocked = columns_beyond(side_ - mask.width + 1);
        for (std::uint32_t j = 0; j < mask.height; ++j)
            for (const CellRun& run : mask.row(j)) {
                Row taken = rows_[y + j];
                for (std::uint32_t have = 1; have < run.count;) {
                    const std::uint32_t more = std::min(have, run.count - have);
                    taken = taken | shifted_down(taken, more);
                    have += more;
                }
                blocked = blocked | shifted_down(taken, run.first);
                if (blocked[0] == all && blocked[1] == all) return side_;
            }
        for (std::uint32_t i = 0; i < words; ++i)
            if (blocked[i] != all) return 64 * i + std::uint32_t(std::countr_one(blocked[i]));
        return side_;
    }

    static Row columns_beyond(std::uint32_t first) {
        Row row{all, all};
        for (std::uint32_t i = 0; i < words; ++i)
            if (first >= 64 * (i + 1))
                row[i] = 0;
            else if (first > 64 * i)
                row[i] = all << (first - 64 * i);
        return row;
    }

    static constexpr std::uint64_t all = ~std::uint64_t(0);
    std::uint32_t side_;
    std::vector<Row> rows_;
};

/// The masks of all outlines at one scale.
using Masks = std::vector<Turns>;

/// Packs in given orders at given scales.
class Packer {
  public:
    Packer(std::span<const Outline> outlines, std::uint32_t size)
        : outlines_(outlines), cell_(outline_cell(size)), side_(size / cell_) {}

    std::uint32_t cell() const { return cell_; }

    Masks masks(double scale) const {
        Masks result(outlines_.size());
        MaskMaker make(scale, cell_);
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = make(outlines_[i]);
        return result;
    }

    /// The outlines' places in the order, or nothing if one finds none.
    std::optional<std::vector<PackedOutline>> pack(std::span<const std::uint32_t> order,
                                                   const Masks& masks) const {
        std::vector<PackedOutline> result(outlines_.size());
        Grid grid(side_);
        for (const std::uint32_t i : order)
            if (!place(masks[i], grid, result[i])) return std::nullopt;
        return result;
    }

  private:
    bool place(const Turns& turns, Grid& grid, PackedOutline& result) const {
        double lowest = std::numeric_limits<double>::infinity();
        const Mask* best = nullptr;
        std::array<std::uint32_t, 2> at{};
        for (const Mask& mask : turns) {
            const auto free = grid.find(mask, lowest);
            if (!free) continue;
            lowest = (*free)[1] + mask.weight_y;
            at = *free;
            best = &mask;
        }
        if (best == nullptr) return false;
        grid.take(*best, at[0], at[1]);
        result = best->placed;
        result.origin += double(cell_) * Vec2d(at[0], at[1]);
        return true;
    }

    std::span<const Outline> outlines_;
    std::uint32_t cell_, side_;
};

/// The search for the order and the scale.
class Search {
  public:
    Search(std::span<const Outline> outlines, std::uint32_t size)
        : packer_(outlines, size), count_(outlines.size()) {
        double area = 0.0;
        for (const Outline& o : outlines) area += o.area;
        most_scale_ = double(size) / std::sqrt(std::max(area, 1e-300));
        order_.resize(count_);
        std::iota(order_.begin(), order_.end(), 0u);
        std::ranges::stable_sort(order_, [&](std::uint32_t a, std::uint32_t b) {
            return outlines[a].area > outlines[b].area;
        });
    }

    std::optional<Packing> run() {
        double high = most_scale_;
        for (int steps = 0; steps < 200; ++steps, high = most_scale_) {
            most_scale_ *= scale_step;
            if (try_scale(order_, most_scale_)) break;
        }
        if (best_.outlines.empty()) return std::nullopt;
        refine(order_, high);
        try_orders();
        best_.cell = packer_.cell();
        return std::move(best_);
    }

  private:
    bool try_scale(std::span<const std::uint32_t> order, double scale) {
        if (scale != masks_scale_) masks_ = packer_.masks(scale);
        masks_scale_ = scale;
        auto packed = packer_.pack(order, masks_);
        if (!packed) return false;
        best_.outlines = std::move(*packed);
        best_.scale = scale;
        return true;
    }

    /// Halves the step between the best scale and one that does not fit.
    void refine(std::span<const std::uint32_t> order, double high) {
        for (int i = 0; i < scale_halvings; ++i) {
            const double middle = 0.5 * (best_.scale + high);
            if (!try_scale(order, middle)) high = middle;
        }
    }

    /// Swaps outlines that are near in the order, and keeps what allows a larger scale.
    void try_orders() {
        std::uint64_t random = 1;
        const auto below = [&](std::size_t n) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            return std::size_t((random >> 33) % n);
        };
        if (count_ < 2) return;
        for (std::size_t spent = 0; spent < spent_placements; spent += count_) {
            std::vector<std::uint32_t> order = order_;
            for (std::size_t swaps = 1 + below(3); swaps > 0; --swaps) {
                const std::size_t i = below(count_);
                const std::size_t j = i + 1 + below(std::max<std::size_t>(count_ / 4, 1));
                std::swap(order[i], order[std::min(j, count_ - 1)]);
            }
            if (!try_scale(order, best_.scale * order_gain)) continue;
            refine(order, best_.scale / scale_step);
            order_ = std::move(order);
        }
    }

    Packer packer_;
    std::size_t count_;
    double most_scale_ = 0.0;  ///< scale at which the charts' area is the texture's
    std::vector<std::uint32_t> order_;
    Masks masks_;  ///< of the scale tried last
    double masks_scale_ = 0.0;
    Packing best_;
};

}  // namespace

std::uint32_t outline_cell(std::uint32_t size) {
    return std::bit_ceil((size + most_cells - 1) / most_cells);
}

std::optional<Packing> pack_outlines(std::span<const Outline> outlines, std::uint32_t size) {
    const std::size_t side = size / outline_cell(size);
    if (outlines.empty() || outlines.size() > side * side) return std::nullopt;
    return Search(outlines, size).run();
}

}  // namespace burl
