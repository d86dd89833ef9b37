#include "atlas/outline/pack.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "atlas/outline/outline_mask.h"
#include "atlas/outline/spread.h"

namespace burl {
namespace {

/// Ratio between the scales that are tried until one fits, and halvings of the last step.
constexpr double scale_step = 0.96;
constexpr int scale_halvings = 4;
/// Placements of outlines that are spent on trying other orders, and the gain that is wanted of
/// one.
constexpr std::size_t spent_placements = 1200;
constexpr double order_gain = 1.004;

/// Longest runs of cells, as powers of two, for which a grid knows where they would touch.
constexpr std::uint32_t lengths = 8;
static_assert(most_cells >> (lengths - 1) == 1);

/// A square of cells, some of which are taken.
class Grid {
  public:
    explicit Grid(std::uint32_t side) : side_(side), rows_(side, Touched{}) {}

    /// The lowest free place of the mask (row, then column) with its weight below `most`.
    std::optional<std::array<std::uint32_t, 2>> find(const OutlineMask& mask, double most) const {
        if (mask.width > side_ || mask.height > side_) return std::nullopt;
        for (std::uint32_t y = 0; y + mask.height <= side_ && y + mask.weight_y < most; ++y)
            if (const std::uint32_t x = first_free(mask, y); x + mask.width <= side_)
                return std::array<std::uint32_t, 2>{x, y};
        return std::nullopt;
    }

    void take(const OutlineMask& mask, std::uint32_t x, std::uint32_t y) {
        for (std::uint32_t j = 0; j < mask.height; ++j) {
            Touched& row = rows_[y + j];
            for (const CellRun& run : mask.row(j))
                for (std::uint32_t c = x + run.first; c < x + run.first + run.count; ++c)
                    row[0].set(c);
            for (std::uint32_t k = 1; k < lengths; ++k)
                row[k] = row[k - 1] | row[k - 1].moved_down(1u << (k - 1));
        }
    }

  private:
    /// The first column where the mask's low corner is free in row y, or the grid's end.
    std::uint32_t first_free(const OutlineMask& mask, std::uint32_t y) const {
        GridRow blocked = columns_beyond(side_ - mask.width + 1);
        if (block(mask, mask.fullest, y, blocked)) return side_;
        for (std::uint32_t j = 0; j < mask.height; ++j)
            if (block(mask, j, y, blocked)) return side_;
        return std::min(blocked.leading(), side_);
    }

    /// Marks the columns from which row j of the mask, in row y + j, touches a taken cell. Whether
    /// all are marked now.
    bool block(const OutlineMask& mask, std::uint32_t j, std::uint32_t y, GridRow& blocked) const {
        for (const CellRun& run : mask.row(j)) {
            const auto k = std::uint32_t(std::bit_width(run.count)) - 1;
            const GridRow& touched = rows_[y + j][k];
            blocked = blocked | touched.moved_down(run.first) |
                      touched.moved_down(run.first + run.count - (1u << k));
        }
        return blocked.full();
    }

    static GridRow columns_beyond(std::uint32_t first) {
        constexpr std::uint64_t all = ~std::uint64_t(0);
        if (first >= most_cells) return {};
        return first < 64 ? GridRow{all << first, all} : GridRow{0, all << (first - 64)};
    }

    /// The columns from which a run of 2^k cells would touch a taken one, for each k.
    using Touched = std::array<GridRow, lengths>;

    std::uint32_t side_;
    std::vector<Touched> rows_;
};

/// A turn of an outline, and the cell of its mask's low corner.
struct Spot {
    std::uint32_t turn = 0, x = 0, y = 0;
};

/// The masks of all outlines at one scale.
using Masks = std::vector<TurnedMasks>;

/// Packs in given orders at given scales.
class Packer {
  public:
    Packer(std::span<const Outline> outlines, std::uint32_t size)
        : outlines_(outlines), cell_(outline_cell(size)), side_(size / cell_) {}

    Masks masks(double scale) const {
        Masks result(outlines_.size());
        MaskMaker make(scale, cell_);
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = make(outlines_[i]);
        return result;
    }

    /// The outlines' spots, found in the order given, or nothing if one finds none.
    std::optional<std::vector<Spot>> pack(std::span<const std::uint32_t> order,
                                          const Masks& masks) const {
        std::vector<Spot> result(outlines_.size());
        Grid grid(side_);
        for (const std::uint32_t i : order)
            if (!place(masks[i], grid, result[i])) return std::nullopt;
        return result;
    }

    /// The outlines in their spots, moved apart.
    PackedOutlines spread(std::span<const Spot> spots, double scale) const {
        const Masks turned = masks(scale);
        std::vector<PlacedMask> placed;
        for (std::size_t i = 0; i < spots.size(); ++i)
            placed.push_back({&turned[i][spots[i].turn], spots[i].x, spots[i].y});
        spread_masks(placed, side_);
        PackedOutlines result{{}, scale, cell_};
        for (const PlacedMask& p : placed) {
            PackedOutline outline = p.mask->placed;
            outline.origin += double(cell_) * Vec2d(p.x, p.y);
            result.outlines.push_back(outline);
        }
        return result;
    }

  private:
    bool place(const TurnedMasks& turns, Grid& grid, Spot& result) const {
        double lowest = std::numeric_limits<double>::infinity();
        for (std::uint32_t turn = 0; turn < turns.size(); ++turn) {
            const auto free = grid.find(turns[turn], lowest);
            if (!free) continue;
            lowest = (*free)[1] + turns[turn].weight_y;
            result = {turn, (*free)[0], (*free)[1]};
        }
        if (!(lowest < std::numeric_limits<double>::infinity())) return false;
        grid.take(turns[result.turn], result.x, result.y);
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

    std::optional<PackedOutlines> run() {
        double high = most_scale_;
        for (int steps = 0; steps < 200; ++steps, high = most_scale_) {
            most_scale_ *= scale_step;
            if (try_scale(order_, most_scale_)) break;
        }
        if (spots_.empty()) return std::nullopt;
        refine(order_, high);
        try_orders();
        return packer_.spread(spots_, scale_);
    }

  private:
    bool try_scale(std::span<const std::uint32_t> order, double scale) {
        if (scale != masks_scale_) masks_ = packer_.masks(scale);
        masks_scale_ = scale;
        auto packed = packer_.pack(order, masks_);
        if (!packed) return false;
        spots_ = std::move(*packed);
        scale_ = scale;
        return true;
    }

    /// Halves the step between the best scale and one that does not fit.
    void refine(std::span<const std::uint32_t> order, double high) {
        for (int i = 0; i < scale_halvings; ++i) {
            const double middle = 0.5 * (scale_ + high);
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
            if (!try_scale(order, scale_ * order_gain)) continue;
            refine(order, scale_ / scale_step);
            order_ = std::move(order);
        }
    }

    Packer packer_;
    std::size_t count_;
    double most_scale_ = 0.0;  ///< scale at which the charts' area is the texture's
    std::vector<std::uint32_t> order_;
    Masks masks_;  ///< of the scale tried last
    double masks_scale_ = 0.0;
    std::vector<Spot> spots_;  ///< of the largest scale that fits, which is `scale_`
    double scale_ = 0.0;
};

}  // namespace

std::uint32_t outline_cell(std::uint32_t size) {
    return std::bit_ceil((size + most_cells - 1) / most_cells);
}

std::optional<PackedOutlines> pack_outlines(std::span<const Outline> outlines, std::uint32_t size) {
    const std::size_t side = size / outline_cell(size);
    if (outlines.empty() || outlines.size() > side * side) return std::nullopt;
    return Search(outlines, size).run();
}

}  // namespace burl
