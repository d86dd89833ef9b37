// The direction in which every node is halved, by a dynamic programme over (node, log2 of its
// aspect) for the least sum of the blocks' predicted errors. A node's texels are known from its
// depth, so its aspect gives its sides.
#include "atlas/blocks/quad_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <tbb/parallel_invoke.h>

#include "atlas/base/each_index.h"
#include "atlas/blocks/quad_arrangement.h"
#include "atlas/solid/block.h"

namespace burl {

namespace {

constexpr std::uint32_t most_log_side = 14;
static_assert(max_atlas_size == 1u << most_log_side);
constexpr std::size_t many_items = 4096;  // items from which a node's halves are built in parallel
constexpr double infinite = std::numeric_limits<double>::infinity();
// Ratio of errors within which a block may be turned for its neighbours' sake.
constexpr double equal_errors = 1.02;
// Relative cost of a node for each doubling of its aspect beyond 2: long nodes are bad for levels
// above their blocks. Values of 0.01 to 0.1 all do.
constexpr double squareness_penalty = 0.03;

/// Least error of a node for each log2(width / height); infinite where that cannot occur.
class Costs {
  public:
    Costs() { costs_.fill(infinite); }
    double& operator[](int aspect) { return costs_[std::size_t(aspect + most_quad_aspect)]; }
    double at(int aspect) const {
        const bool known = std::abs(aspect) <= most_quad_aspect;
        return known ? costs_[std::size_t(aspect + most_quad_aspect)] : infinite;
    }

  private:
    std::array<double, 2 * most_quad_aspect + 1> costs_;
};

/// The quadtree over the cells of an atlas.
class Tree {
  public:
    Tree(std::span<const QuadCell> cells, std::vector<QuadItem> items, const AtlasOptions& options,
         const Halve& halve);
    /// Builds the subtree of items [first, first + count) at `node`, down to single items, on
    /// 2^log_texels texels; returns its least errors. `depth` bounds the aspects that can occur.
    Costs build(std::size_t node, std::size_t first, std::size_t count, int log_texels, int depth);
    /// The leaves, neighbours on the surface side by side where possible; to be called after
    /// build().
    std::vector<QuadLeaf> leaves(int log_size) const;

  private:
    double leaf_cost(const QuadCell& cell, int log_width, int log_height, bool turned) const;
    Costs leaf_costs(std::size_t item, int log_texels, int reach) const;
    QuadLeaf place(const QuadItem& item, const QuadSpot& spot) const;
    void place_together(std::span<const QuadItem> items, const QuadPlace& at,
                        QuadLeaf* leaves) const;

    std::span<const QuadCell> cells_;
    std::vector<QuadItem> items_;
    const Halve& halve_;
    std::vector<QuadNode> nodes_;
    /// inverse_squares_[a][b] is 1 / leg^2 for a leg along a side of 2^a texels where the other
    /// side has 2^b.
    std::array<std::array<double, most_log_side + 1>, most_log_side + 1> inverse_squares_{};
};

Vec3d place_of(const QuadItem& item) {
    return {item.key[0], item.key[1], item.key[2]};
}

/// Weighted mean of the items' places; each item counts for its weight plus one unit.
Vec3d middle(std::span<const QuadItem> items) {
    Vec3d sum{0.0};
    double weight = 0.0;
    for (const QuadItem& item : items) {
        const double own = double(item.weight) + 1.0;
        sum += own * place_of(item);
        weight += own;
    }
    return sum / weight;
}

Tree::Tree(std::span<const QuadCell> cells, std::vector<QuadItem> items,
           const AtlasOptions& options, const Halve& halve)
    : cells_(cells), items_(std::move(items)), halve_(halve), nodes_(2 * items_.size() - 1) {
    for (std::uint32_t log = 0; log <= most_log_side; ++log)
        for (std::uint32_t other = 0; other <= most_log_side; ++other) {
            const double border = border_texels(options.overscan) +
                                  2.0 * quad_gutter(options, 1u << log, 1u << other);
            // A side of one texel shows the middle of the cell.
            const double leg = std::max(0.5, double(1u << log) - border);
            inverse_squares_[log][other] = 1.0 / (leg * leg);
        }
}

double Tree::leaf_cost(const QuadCell& cell, int log_width, int log_height, bool turned) const {
    const auto w = std::size_t(turned ? log_height : log_width);
    const auto h = std::size_t(turned ? log_width : log_height);
    const double x = inverse_squares_[w][h], y = inverse_squares_[h][w];
    return cell.error[0] * x * x + cell.error[1] * x * y + cell.error[2] * y * y;
}

Costs Tree::leaf_costs(std::size_t item, int log_texels, int reach) const {
    const QuadCell& cell = cells_[items_[item].cell];
    Costs costs;
    for (int aspect = -reach; aspect <= reach; ++aspect) {
        if ((aspect + log_texels) % 2 != 0) continue;
        const int log_width = (log_texels + aspect) / 2, log_height = log_texels - log_width;
        costs[aspect] = std::min(leaf_cost(cell, log_width, log_height, false),
                                 leaf_cost(cell, log_width, log_height, true));
    }
    return costs;
}

/// Bounds of the first half of a node: as long as there are texels for all items none may lack one;
/// else no texel may lack an item.
HalfBounds half_bounds(std::size_t items, std::size_t texels) {
    const std::size_t half = texels / 2;
    if (items > texels) return {half, items - half};
    const std::size_t most = std::min(half, items - 1);
    return {items - most, most};
}

Costs Tree::build(std::size_t node, std::size_t first, std::size_t count, int log_texels,
                  int depth) {
    const int reach = std::min({depth, log_texels, most_quad_aspect});
    nodes_[node].first = static_cast<std::uint32_t>(first);
    nodes_[node].count = static_cast<std::uint32_t>(count);
    nodes_[node].centre = middle({items_.data() + first, count});
    if (count == 1 || log_texels == 0) return leaf_costs(first, log_texels, reach);
    const std::size_t half = halve_.run({items_.data() + first, count},
                                        half_bounds(count, std::size_t{1} << log_texels));
    nodes_[node].half = static_cast<std::uint32_t>(half);
    Costs a, b;
    const auto first_half = [&] { a = build(node + 1, first, half, log_texels - 1, depth + 1); };
    const auto second_half = [&] {
        b = build(node + 2 * half, first + half, count - half, log_texels - 1, depth + 1);
    };
    if (halve_.apart && count > many_items) {
        tbb::parallel_invoke(first_half, second_half);
    } else {
        first_half();
        second_half();
    }
    Costs costs;
    for (int aspect = -reach; aspect <= reach; ++aspect) {
        if ((aspect + log_texels) % 2 != 0) continue;
        const double in_width = a.at(aspect - 1) + b.at(aspect - 1);
        const double in_height = a.at(aspect + 1) + b.at(aspect + 1);
        if (in_height < in_width)
            nodes_[node].upright |= std::uint64_t{1} << (aspect + most_quad_aspect);
        costs[aspect] = std::min(in_width, in_height) *
                        (1.0 + squareness_penalty * std::max(0, std::abs(aspect) - 1));
    }
    return costs;
}

/// Puts several items on one texel, the item nearest to their weighted mean first.
void Tree::place_together(std::span<const QuadItem> items, const QuadPlace& at,
                          QuadLeaf* leaves) const {
    const Vec3d centre = middle(items);
    std::vector<std::pair<double, std::uint32_t>> ranks;
    for (const QuadItem& item : items) {
        const Vec3d off = place_of(item) - centre;
        ranks.emplace_back(glm::dot(off, off), item.cell);
    }
    std::sort(ranks.begin(), ranks.end());
    for (std::size_t i = 0; i < ranks.size(); ++i)
        leaves[i] = {ranks[i].second, at.x, at.y, 1, 1, false, i > 0};
}

QuadLeaf Tree::place(const QuadItem& item, const QuadSpot& spot) const {
    const QuadPlace& at = spot.at;
    const QuadCell& cell = cells_[item.cell];
    const double upright = leaf_cost(cell, at.log_width, at.log_height, false),
                 turned = leaf_cost(cell, at.log_width, at.log_height, true);
    QuadLeaf leaf{item.cell, at.x, at.y, 1u << at.log_width, 1u << at.log_height, turned < upright};
    leaf.may_turn = std::max(upright, turned) <= equal_errors * std::min(upright, turned);
    leaf.beside = spot.beside;
    return leaf;
}

std::vector<QuadLeaf> Tree::leaves(int log_size) const {
    const std::vector<QuadSpot> spots = arrange(nodes_, log_size);
    std::vector<std::size_t> begin(spots.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        begin[i] = count;
        count += nodes_[spots[i].node].count;
    }
    std::vector<QuadLeaf> leaves(count);
    for_each_index(spots.size(), [&](std::size_t i) {
        const QuadNode& node = nodes_[spots[i].node];
        QuadLeaf* const own = leaves.data() + begin[i];
        if (node.count > 1)
            place_together({items_.data() + node.first, node.count}, spots[i].at, own);
        else
            *own = place(items_[node.first], spots[i]);
    });
    return leaves;
}

}  // namespace

std::vector<QuadLeaf> plan_quad_tree(std::span<const QuadCell> cells, const AtlasOptions& options,
                                     const Halve& halve) {
    if (cells.empty()) return {};
    const int log_size = std::bit_width(options.size) - 1;
    Tree tree(cells, quad_items(cells, options), options, halve);
    tree.build(0, 0, cells.size(), 2 * log_size, 0);
    return tree.leaves(log_size);
}

}  // namespace burl
