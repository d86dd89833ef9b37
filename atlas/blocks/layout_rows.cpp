// Row planning for sorted cells. A scale (texels per weight) is found by bisection: first such that
// rows of square cells are N texels high together, then, with whole-texel heights fixed, such that
// the cells end exactly where the last row does.
#include "atlas/blocks/layout_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "atlas/blocks/strips.h"
#include "atlas/solid/atlas.h"
#include "atlas/solid/block.h"

namespace burl {

namespace {

/// Bisections of a scale: 2^-40 of its range is left.
constexpr int bisection_steps = 40;

/// Width in texels of the cell when its horizontal leg is one texel long; `first` says that it
/// begins a row.
std::uint32_t narrowest_width(const Cell& cell, bool first, Overscan mode) {
    const std::uint32_t border = border_texels(mode);
    if (cell.holds_strangers()) return 1 + border + overscan_columns(mode, 1, 1);
    return cell.joins_previous && !first ? 1 : 1 + border;
}

/// Sum of the narrowest widths of a row's cells, in texels.
std::uint64_t narrowest_row(std::span<const Cell> row, Overscan mode) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i) sum += narrowest_width(row[i], i == 0, mode);
    return sum;
}

/// Width of a cell as a function of the scale: max(least, base + slope * scale * weight).
struct WidthLaw {
    double least = 0.0, base = 0.0, slope = 1.0, weight = 0.0;
    double operator()(double scale) const { return std::max(least, base + slope * scale * weight); }
};

std::vector<WidthLaw> width_laws(std::span<const Cell> row, Overscan mode, double leg_y) {
    const double border = border_texels(mode);
    const bool weightless =
        std::all_of(row.begin(), row.end(), [](const Cell& c) { return c.weight == 0.0; });
    std::vector<WidthLaw> laws;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const Cell& cell = row[i];
        WidthLaw law{double(narrowest_width(cell, i == 0, mode)), border, 1.0, cell.weight};
        if (weightless) law.weight = 1.0;
        if (cell.joins_previous && i > 0) law.base = 0.0;
        if (cell.holds_strangers()) {
            // The overscan grows with the leg: 1 + 2 sx/sy columns for bilinear lookups, sx/sy for
            // nearest ones.
            const bool bilinear = mode == Overscan::bilinear;
            law.base += bilinear ? 1.0 : 0.0;
            law.slope += (bilinear ? 2.0 : 1.0) / leg_y;
        }
        laws.push_back(law);
    }
    return laws;
}

double total_width(std::span<const WidthLaw> laws, double scale) {
    double sum = 0.0;
    for (const WidthLaw& law : laws) sum += law(scale);
    return sum;
}

/// Real widths by these laws that add up to `width`.
std::vector<double> real_widths(std::span<const WidthLaw> laws, double width) {
    double weight = 0.0;
    for (const WidthLaw& law : laws) weight = std::max(weight, law.weight);
    double low = 0.0, high = width / weight;
    for (int step = 0; step < bisection_steps; ++step) {
        const double middle = 0.5 * (low + high);
        (total_width(laws, middle) <= width ? low : high) = middle;
    }
    std::vector<double> widths;
    const double spare = std::max(0.0, width - total_width(laws, low)) / double(laws.size());
    for (const WidthLaw& law : laws) widths.push_back(law(low) + spare);
    return widths;
}

/// Snapping of widths: two unrelated triangles in a block waste no column when their legs are
/// equal, so such a block takes the width for equal legs while the cells after it can make up for
/// it.
struct Snap {
    std::uint32_t width = 0;  // block of unrelated triangles with equal legs, texels
    double most_carry = 4.0;  // texels of the row that may be owed
    bool good(double wanted, double carry, double slack_after) const {
        return std::abs(wanted - width) <= 2.5 && std::abs(wanted + carry - width) <= most_carry &&
               slack_after >= 2.0 * most_carry;
    }
};

/// Widths of the cells, in texels, that add up to `width`, with horizontal legs in proportion to
/// the cells' weights; the row is `height` texels high. Requires narrowest_row(row) <= width.
/// Errors of rounding are carried along the row, so that neighbours differ by a texel.
std::vector<std::uint32_t> row_widths(std::span<const Cell> row, Overscan mode, std::uint32_t width,
                                      std::uint32_t height) {
    const std::uint32_t border = border_texels(mode), leg_y = height - border;
    const std::vector<WidthLaw> laws = width_laws(row, mode, leg_y);
    const std::vector<double> wanted = real_widths(laws, width);
    const Snap snap{leg_y + border + overscan_columns(mode, leg_y, leg_y)};
    double slack = 0.0, carry = 0.0;  // width later cells can give up; width to hand out
    for (std::size_t i = 0; i < row.size(); ++i) slack += wanted[i] - laws[i].least;
    std::vector<std::uint32_t> widths;
    std::uint32_t left = width;
    for (std::size_t i = 0; i < row.size(); ++i) {
        slack -= wanted[i] - laws[i].least;
        double here = std::max(laws[i].least, std::round(wanted[i] + carry));
        if (row[i].holds_strangers() && snap.good(wanted[i], carry, slack)) here = snap.width;
        if (i + 1 == row.size()) here = left;
        carry += wanted[i] - here;
        widths.push_back(static_cast<std::uint32_t>(here));
        left -= widths.back();
    }
    return widths;
}

/// Integers that add up to `total`, each the floor or the ceiling of its part, by largest remainder
/// (ties go to the first). The parts must add up to `total` but for rounding.
std::vector<std::uint32_t> whole_parts(std::span<const double> parts, std::uint32_t total) {
    std::vector<std::uint32_t> whole;
    std::int64_t missing = total;
    for (const double part : parts) {
        whole.push_back(static_cast<std::uint32_t>(std::floor(part + 1e-9)));
        missing -= whole.back();
    }
    std::vector<std::size_t> order(parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return parts[a] - whole[a] > parts[b] - whole[b];
    });
    for (std::size_t i = 0; missing > 0; i = (i + 1) % order.size(), --missing) ++whole[order[i]];
    return whole;
}

class RowPlanner {
  public:
    RowPlanner(std::span<const Cell> cells, Overscan mode, std::uint32_t size)
        : cells_(cells), mode_(mode), size_(size), border_(border_texels(mode)) {
        for (const Cell& cell : cells) {
            roots_.push_back(std::sqrt(cell.weight));
            total_weight_ += cell.weight;
        }
    }
    RowPlan plan() const;

  private:
    /// Largest scale in [0, enough) for which fits(scale) holds; 0 always fits.
    template <class Fits>
    double largest_scale(Fits fits) const;
    std::vector<CellRow> rows_of_square_cells(double scale) const;
    double wanted_height(const CellRow& row, double scale) const;
    double wanted_heights(std::span<const CellRow> rows, double scale) const;
    void set_heights(std::vector<CellRow>& rows) const;
    std::vector<CellRow> refilled(std::span<const CellRow> rows, double scale) const;
    void refill(std::vector<CellRow>& rows) const;
    double overhead(std::size_t i, bool first) const;
    std::uint32_t least_width(std::size_t i, bool first) const {
        return narrowest_width(cells_[i], first, mode_);
    }

    std::span<const Cell> cells_;
    Overscan mode_;
    std::uint32_t size_, border_;
    std::vector<double> roots_;
    double total_weight_ = 0.0;
};

/// Columns of cell i beside its horizontal leg, with equal legs.
double RowPlanner::overhead(std::size_t i, bool first) const {
    const Cell& cell = cells_[i];
    if (cell.holds_strangers()) return border_ + overscan_columns(mode_, 8, 8);
    return cell.joins_previous && !first ? 0.0 : border_;
}

template <class Fits>
double RowPlanner::largest_scale(Fits fits) const {
    if (!(total_weight_ > 0.0)) return 0.0;
    double low = 0.0, high = 2.0 * double(size_) * double(size_) / total_weight_;
    for (int step = 0; step < bisection_steps; ++step) {
        const double middle = 0.5 * (low + high);
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

/// Rows of about equal total width when every cell is as wide as it is high. At scale 0 the cells
/// are as narrow and the rows as full as can be.
std::vector<CellRow> RowPlanner::rows_of_square_cells(double scale) const {
    const double root_scale = std::sqrt(scale);
    double target = std::numeric_limits<double>::infinity();
    const auto width = [&](std::size_t i, bool first) {
        return std::max(1.0, root_scale * roots_[i]) + overhead(i, first);
    };
    if (scale > 0.0) {
        double all = 0.0;
        for (std::size_t i = 0; i < cells_.size(); ++i) all += width(i, false);
        const double count = all / size_;
        const double low = std::max(1.0, std::floor(count));
        target = all / (count * count > low * (low + 1.0) ? low + 1.0 : low);
    }
    std::vector<CellRow> rows;
    double end = 0.0;
    std::uint64_t least = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const double here = width(i, false);
        const bool full = rows.empty() || least + least_width(i, false) > size_ ||
                          end + 0.5 * here > target * double(rows.size());
        if (full) {
            rows.push_back({i, 0, 0, 0});
            least = 0;
        }
        end += here;
        least += least_width(i, full);
        ++rows.back().count;
    }
    return rows;
}

/// Height in texels with which the row's cells get their share of texels.
double RowPlanner::wanted_height(const CellRow& row, double scale) const {
    double weight = 0.0, columns = size_;
    for (std::size_t i = row.first; i < row.first + row.count; ++i) {
        weight += cells_[i].weight;
        columns -= overhead(i, i == row.first);
    }
    return border_ + std::max(1.0, scale * weight / std::max(columns, double(row.count)));
}

double RowPlanner::wanted_heights(std::span<const CellRow> rows, double scale) const {
    double sum = 0.0;
    for (const CellRow& row : rows) sum += wanted_height(row, scale);
    return sum;
}

/// Sets whole heights that add up to N, by largest remainder.
void RowPlanner::set_heights(std::vector<CellRow>& rows) const {
    const double scale =
        largest_scale([&](double s) { return wanted_heights(rows, s) <= double(size_); });
    std::vector<double> wanted;
    wanted.reserve(rows.size());
    for (const CellRow& row : rows) wanted.push_back(wanted_height(row, scale));
    const double spare = std::max(0.0, size_ - std::accumulate(wanted.begin(), wanted.end(), 0.0));
    for (double& height : wanted) height += spare / double(rows.size());
    const std::vector<std::uint32_t> heights = whole_parts(wanted, size_);
    std::uint32_t y = 0;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        rows[r].y = y;
        rows[r].height = heights[r];
        y += heights[r];
    }
}

/// Rows of the given heights with the cells moved along so that each row is filled at this scale;
/// the last row ends before the last cell when they do not all fit.
std::vector<CellRow> RowPlanner::refilled(std::span<const CellRow> rows, double scale) const {
    std::vector<CellRow> filled(rows.begin(), rows.end());
    std::size_t i = 0;
    double carry = 0.0;  // width by which the rows so far are overfull
    for (CellRow& row : filled) {
        const double leg_y = row.height - border_;
        double used = carry;
        std::uint64_t least = 0;
        row.first = i;
        for (; i < cells_.size(); ++i) {
            const bool first = i == row.first;
            const double width =
                std::max(1.0, scale * cells_[i].weight / leg_y) + overhead(i, first);
            least += least_width(i, first);
            if (least > size_ || (!first && used + 0.5 * width > size_)) break;
            used += width;
        }
        row.count = i - row.first;
        carry = std::clamp(used - size_, -0.5 * size_, 0.5 * size_);
    }
    return filled;
}

void RowPlanner::refill(std::vector<CellRow>& rows) const {
    const auto holds_all = [&](const std::vector<CellRow>& filled) {
        const CellRow& last = filled.back();
        return last.count > 0 && last.first + last.count == cells_.size();
    };
    const double scale = largest_scale([&](double s) {
        const CellRow last = refilled(rows, s).back();
        return last.first + last.count == cells_.size();
    });
    std::vector<CellRow> filled = refilled(rows, scale);
    if (holds_all(filled)) rows = std::move(filled);
}

RowPlan RowPlanner::plan() const {
    const double scale = largest_scale(
        [&](double s) { return wanted_heights(rows_of_square_cells(s), s) <= double(size_); });
    std::vector<CellRow> rows = rows_of_square_cells(scale);
    const std::uint32_t least_height = 1 + border_;
    if (rows.size() * std::uint64_t{least_height} > size_) return {};
    for (const CellRow& row : rows)
        if (narrowest_row(cells_.subspan(row.first, row.count), mode_) > size_) return {};
    set_heights(rows);
    refill(rows);
    RowPlan plan{rows, {}};
    plan.widths.reserve(cells_.size());
    for (const CellRow& row : rows) {
        const auto widths =
            row_widths(cells_.subspan(row.first, row.count), mode_, size_, row.height);
        plan.widths.insert(plan.widths.end(), widths.begin(), widths.end());
    }
    return plan;
}

}  // namespace

RowPlan plan_rows(std::span<const Cell> cells, Overscan mode, std::uint32_t size) {
    return cells.empty() ? RowPlan{} : RowPlanner(cells, mode, size).plan();
}

}  // namespace burl
