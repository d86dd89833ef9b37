#include "atlas/blocks/quad_graph.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "atlas/mesh/dual_graph.h"
#include "atlas/solid/weights.h"

namespace burl {

namespace {

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
