// Whole-texel widths for one row of cells. Errors of rounding are carried along the row, so that
// neighbours differ by a texel and the end is met exactly.
#include "atlas/blocks/row_widths.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "atlas/solid/overscan.h"

namespace burl {

namespace {

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
    for (int step = 0; step < 40; ++step) {
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

}  // namespace

std::uint32_t narrowest_width(const Cell& cell, bool first, Overscan mode) {
    const std::uint32_t border = border_texels(mode);
    if (cell.holds_strangers()) return 1 + border + overscan_columns(mode, 1, 1);
    return cell.joins_previous && !first ? 1 : 1 + border;
}

std::uint64_t narrowest_row(std::span<const Cell> row, Overscan mode) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < row.size(); ++i) sum += narrowest_width(row[i], i == 0, mode);
    return sum;
}

std::vector<std::uint32_t> row_widths(std::span<const Cell> row, Overscan mode, std::uint32_t width,
                                      std::uint32_t height) {
    const std::uint32_t border = border_texels(mode), leg_y = height - border;
    const std::vector<WidthLaw> laws = width_laws(row, mode, leg_y);
    const std::vector<double> wanted = real_widths(laws, width);
    const Snap snap{leg_y + border + overscan_columns(mode, leg_y, leg_y)};
    double slack = 0.0,
           carry = 0.0;  // width later cells can give up; width to hand out
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

}  // namespace burl
