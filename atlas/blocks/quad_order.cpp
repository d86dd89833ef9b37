#include "atlas/blocks/quad_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "atlas/mesh/dual_graph.h"
#include "atlas/solid/block.h"
#include "atlas/solid/weights.h"

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
    const std::size_t allowed = std::clamp(count, least, most);
    if (allowed != count)
        std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(allowed), items.end(),
                         by_key);
    return allowed;
}

constexpr std::size_t few_cells = 24;  // up to here cells are halved by place
constexpr double mean_edge_units = 64.0, most_edge_units = 64000.0;
constexpr int seed = 1;

std::vector<std::int32_t> cells_of_triangles(std::span<const QuadCell> cells,
                                             std::size_t triangles) {
    std::vector<std::int32_t> cell_of(triangles, -1);
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (const std::int32_t t : {cells[i].lower, cells[i].upper})
            if (t >= 0) cell_of[std::size_t(t)] = static_cast<std::int32_t>(i);
    return cell_of;
}

/// Length of each half-edge in whole units (see QuadGraph).
std::vector<std::int32_t> edge_units(const Mesh& mesh) {
    const double scale = unit_scale(mesh);
    std::vector<double> lengths;
    lengths.reserve(3 * mesh.triangles.size());
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            lengths.push_back(glm::distance(scale * mesh.positions[t[k]],
                                            scale * mesh.positions[t[(k + 1) % 3]]));
            sum += lengths.back();
        }
    const double unit = sum > 0.0 ? mean_edge_units * double(lengths.size()) / sum : 0.0;
    std::vector<std::int32_t> units;
    units.reserve(lengths.size());
    for (const double length : lengths)
        units.push_back(1 + static_cast<std::int32_t>(std::min(unit * length, most_edge_units)));
    return units;
}

/// Weights of the items, scaled down so that their sum has about 30 bits.
std::vector<std::int32_t> node_weights(std::span<const QuadItem> items) {
    std::uint64_t total = 0;
    for (const QuadItem& item : items) total += item.weight;
    const int shift = std::max(0, int(std::bit_width(total)) - 30);
    std::vector<std::int32_t> weights;
    weights.reserve(items.size());
    for (const QuadItem& item : items)
        weights.push_back(1 + static_cast<std::int32_t>(item.weight >> shift));
    return weights;
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

QuadGraph::QuadGraph(const Mesh& mesh, std::span<const std::int32_t> opposite,
                     std::span<const QuadCell> cells)
    : local_(cells.size(), -1) {
    const std::vector<std::int32_t> cell_of = cells_of_triangles(cells, mesh.triangles.size());
    const std::vector<std::int32_t> units = edge_units(mesh);
    begin_.push_back(0);
    for (std::int32_t i = 0; std::size_t(i) < cells.size(); ++i) {
        for (const std::int32_t t : {cells[std::size_t(i)].lower, cells[std::size_t(i)].upper}) {
            for (std::int32_t h = 3 * t; t >= 0 && h < 3 * t + 3; ++h) {
                const std::int32_t o = opposite[std::size_t(h)];
                const std::int32_t other = o < 0 ? i : cell_of[std::size_t(o / 3)];
                if (other != i) add_to_last_row(other, units[std::size_t(h)]);
            }
        }
        begin_.push_back(static_cast<std::int32_t>(targets_.size()));
    }
}

void QuadGraph::add_to_last_row(std::int32_t target, std::int32_t length) {
    const auto known = std::find(targets_.begin() + begin_.back(), targets_.end(), target);
    if (known != targets_.end()) {
        lengths_[std::size_t(known - targets_.begin())] += length;
        return;
    }
    targets_.push_back(target);
    lengths_.push_back(length);
}

std::size_t QuadGraph::halve(std::span<QuadItem> items, const HalfBounds& bounds) {
    if (items.size() <= few_cells) return halve_by_place(items, bounds);
    DualGraph graph;
    graph.node_weights = node_weights(items);
    graph.begin.push_back(0);
    for (std::size_t i = 0; i < items.size(); ++i)
        local_[items[i].cell] = static_cast<std::int32_t>(i);
    for (const QuadItem& item : items) {
        for (auto e = std::size_t(begin_[item.cell]); e < std::size_t(begin_[item.cell + 1]); ++e) {
            const std::int32_t other = local_[std::size_t(targets_[e])];
            if (other < 0) continue;
            graph.targets.push_back(other);
            graph.edge_weights.push_back(lengths_[e]);
        }
        graph.begin.push_back(static_cast<std::int32_t>(graph.targets.size()));
    }
    for (const QuadItem& item : items) local_[item.cell] = -1;
    const std::vector<std::uint32_t> part = bisect_graph(graph, seed);
    const auto count = std::size_t(std::count(part.begin(), part.end(), 0u));
    if (count < bounds.least || count > bounds.most) return halve_by_place(items, bounds);
    std::vector<QuadItem> halves;
    halves.reserve(items.size());
    for (const std::uint32_t half : {0u, 1u})
        for (std::size_t i = 0; i < items.size(); ++i)
            if (part[i] == half) halves.push_back(items[i]);
    std::copy(halves.begin(), halves.end(), items.begin());
    return count;
}

}  // namespace burl
