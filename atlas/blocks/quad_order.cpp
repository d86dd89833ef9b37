#include "atlas/blocks/quad_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "atlas/solid/overscan.h"

namespace burl {

namespace {

constexpr std::size_t few_blocks = 24;  // up to here all three axes are tried

/// Texels of a block of mean size beside its legs, along each side.
double mean_border(std::size_t cells, const AtlasOptions& options) {
    const double side = options.size / std::sqrt(double(std::max<std::size_t>(cells, 1)));
    const auto block = static_cast<std::uint32_t>(std::max(1.0, side));
    return border_texels(options.overscan) + 2.0 * quad_gutter(options, block, block);
}

/// Square root of the texels per unit of demand with which blocks, their borders included, fill the
/// texture: n border^2 + b border q + a q^2 = texels, with legs q sqrt(demand aspect^+-1).
double texels_scale(std::span<const QuadCell> cells, double texels, double border) {
    double a = 0.0, b = 0.0;
    for (const QuadCell& cell : cells) {
        const double root = std::sqrt(cell.aspect);
        a += cell.demand;
        b += std::sqrt(cell.demand) * (root + 1.0 / root);
    }
    if (!(a > 0.0)) return 0.0;
    b *= border;
    const double spare = std::max(0.0, texels - border * border * double(cells.size()));
    return spare > 0.0 ? 2.0 * spare / (b + std::sqrt(b * b + 4.0 * a * spare)) : 0.0;
}

double texels_wanted(const QuadCell& cell, double q, double border) {
    const double inner = q * q * cell.demand, root = std::sqrt(cell.aspect);
    return inner + border * std::sqrt(inner) * (root + 1.0 / root) + border * border;
}

struct ByKey {
    std::size_t axis;
    bool operator()(const QuadItem& a, const QuadItem& b) const {
        return a.key[axis] != b.key[axis] ? a.key[axis] < b.key[axis] : a.cell < b.cell;
    }
};

/// A cut of a sequence of items.
struct Cut {
    std::size_t count = 0;  ///< items before the cut
    std::uint64_t off = 0;  ///< difference of twice the weight before it from the total weight
};

std::uint64_t total_weight(std::span<const QuadItem> items) {
    return std::accumulate(items.begin(), items.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const QuadItem& i) { return sum + i.weight; });
}

/// The most even cut with least <= count <= most of items in order; `before` is the weight of the
/// items before them, `whole` the total weight.
Cut best_cut(std::span<const QuadItem> items, std::size_t least, std::size_t most,
             std::uint64_t before, std::uint64_t whole) {
    Cut best{least, ~std::uint64_t{0}};
    for (std::size_t k = 0; k <= std::min(most, items.size()); ++k) {
        const std::uint64_t twice = 2 * before, off = twice > whole ? twice - whole : whole - twice;
        if (k >= least && off < best.off) best = {k, off};
        if (k < items.size()) before += items[k].weight;
    }
    return best;
}

/// The axes in the order of the items' extent along them, widest first.
std::array<std::size_t, 3> axes_by_spread(std::span<const QuadItem> items) {
    std::array<std::uint32_t, 3> low = items[0].key, high = low;
    for (const QuadItem& item : items)
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], item.key[k]);
            high[k] = std::max(high[k], item.key[k]);
        }
    std::array<std::size_t, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
        return high[a] - low[a] > high[b] - low[b];
    });
    return axes;
}

/// Halves a few items along the axis whose best cut is most even.
std::size_t halve_few(std::span<QuadItem> items, std::size_t least, std::size_t most) {
    const std::uint64_t whole = total_weight(items);
    const std::array<std::size_t, 3> axes = axes_by_spread(items);
    Cut best{least, ~std::uint64_t{0}};
    std::size_t best_axis = axes[0], sorted_axis = 3;
    for (const std::size_t axis : axes) {
        std::sort(items.begin(), items.end(), ByKey{sorted_axis = axis});
        const Cut cut = best_cut(items, least, most, 0, whole);
        if (cut.off < best.off) best = cut, best_axis = axis;
        if (items.size() == 2) break;  // all cuts are alike
    }
    if (sorted_axis != best_axis) std::sort(items.begin(), items.end(), ByKey{best_axis});
    return best.count;
}

/// Halves many items at the weighted median along the axis of widest spread, by repeated selection.
std::size_t halve_many(std::span<QuadItem> items, std::size_t least, std::size_t most) {
    const ByKey by_key{axes_by_spread(items)[0]};
    const std::uint64_t whole = total_weight(items);
    std::uint64_t before = 0;
    std::size_t low = 0, high = items.size();
    while (high - low > few_blocks) {
        const std::size_t middle = low + (high - low) / 2;
        std::nth_element(items.begin() + std::ptrdiff_t(low),
                         items.begin() + std::ptrdiff_t(middle),
                         items.begin() + std::ptrdiff_t(high), by_key);
        const std::uint64_t weight = total_weight(items.subspan(low, middle - low));
        if (2 * (before + weight) <= whole) {
            low = middle;
            before += weight;
        } else {
            high = middle;
        }
    }
    const std::span<QuadItem> rest = items.subspan(low, high - low);
    std::sort(rest.begin(), rest.end(), by_key);
    const std::size_t count = low + best_cut(rest, 0, rest.size(), before, whole).count;
    const std::size_t kept = std::clamp(count, least, most);
    if (kept != count)
        std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(kept), items.end(), by_key);
    return kept;
}

}  // namespace

std::uint32_t quad_gutter(const AtlasOptions& options, std::uint32_t width, std::uint32_t height) {
    if (options.overscan == Overscan::nearest) return 0;
    std::uint32_t gutter = options.gutter;
    while (8 * gutter > std::min(width, height)) gutter /= 2;
    return gutter;
}

std::vector<QuadItem> quad_items(std::span<const QuadCell> cells, const AtlasOptions& options) {
    const double border = mean_border(cells.size(), options);
    const double q = texels_scale(cells, double(options.size) * double(options.size), border);
    std::vector<QuadItem> items(cells.size());
    if (cells.empty()) return items;
    Vec3d low = cells[0].centre, high = low;
    for (const QuadCell& cell : cells) {
        low = glm::min(low, cell.centre);
        high = glm::max(high, cell.centre);
    }
    const Vec3d box = high - low;
    const double longest = std::max({box.x, box.y, box.z});
    const double steps = longest > 0.0 ? 0x1p24 / longest : 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Vec3d key = glm::floor(steps * (cells[i].centre - low));
        const double texels = texels_wanted(cells[i], q, border);
        items[i] = {{std::uint32_t(key.x), std::uint32_t(key.y), std::uint32_t(key.z)},
                    static_cast<std::uint32_t>(i),
                    static_cast<std::uint64_t>(std::ldexp(texels, 20))};
    }
    return items;
}

std::size_t halve_by_place(std::span<QuadItem> items, const HalfBounds& bounds) {
    return items.size() <= few_blocks ? halve_few(items, bounds.least, bounds.most)
                                      : halve_many(items, bounds.least, bounds.most);
}

}  // namespace burl
