#include "app/edit/graph_flow.h"

#include <algorithm>
#include <cstddef>

namespace burl {

namespace {

constexpr int sweeps = 8;

/// A wire from the output of one node to an input of another.
struct Link {
    std::size_t from, to, input;
};

class FlowLayout {
  public:
    FlowLayout(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
               const std::vector<std::size_t>& nodes, const Vec2d& gap)
        : graph_(graph), boxes_(boxes), nodes_(nodes), gap_(gap), y_(graph.nodes.size(), 0.0) {
        std::vector<bool> is_one(graph.nodes.size(), false);
        for (const std::size_t node : nodes) is_one[node] = true;
        for (const std::size_t to : nodes)
            for (std::size_t k = 0; k < graph.nodes[to].inputs.size(); ++k)
                if (const auto from = graph.nodes[to].inputs[k].from; from && is_one[*from])
                    links_.push_back({*from, to, k});
    }

    GraphLayout run() {
        find_columns();
        order_columns();
        stack();
        for (int i = 0; i < sweeps; ++i) settle(i % 2 == 0);
        settle(true);
        return places();
    }

  private:
    /// The column of every node: the longest way to one that nothing uses; where the material is
    /// among them it is alone in the last one.
    void find_columns() {
        const bool all = nodes_.front() == 0;
        column_.assign(graph_.nodes.size(), all ? 1 : 0);
        column_[0] = 0;
        // A way has no more wires than there are nodes.
        bool changed = true;
        while (changed) {
            changed = false;
            for (const Link& link : links_) {
                if (column_[link.from] > column_[link.to]) continue;
                column_[link.from] = column_[link.to] + 1;
                changed = true;
            }
        }
        for (const std::size_t node : nodes_) {
            columns_.resize(std::max(columns_.size(), column_[node] + 1));
            columns_[column_[node]].push_back(node);
        }
    }

    /// Sorts nodes by the means of the ranks of those that they are connected to, column by column
    /// in both directions, and keeps the order with the fewest crossings.
    void order_columns() {
        rank_.resize(graph_.nodes.size());
        set_ranks();
        auto best = columns_;
        std::size_t fewest = crossings();
        for (int i = 0; i < sweeps && fewest > 0; ++i) {
            for (std::size_t c = 0; c < columns_.size(); ++c)
                sort_column(columns_[i % 2 == 0 ? c : columns_.size() - 1 - c], i % 2 == 0);
            if (const std::size_t now = crossings(); now < fewest) {
                fewest = now;
                best = columns_;
            }
        }
        columns_ = best;
    }

    void set_ranks() {
        for (const std::vector<std::size_t>& column : columns_) set_ranks(column);
    }
    void set_ranks(const std::vector<std::size_t>& column) {
        for (std::size_t r = 0; r < column.size(); ++r)
            rank_[column[r]] = (double(r) + 0.5) / double(column.size());
    }

    /// Sorts a column by its nodes' users (`by_users`) or by what they are made of.
    void sort_column(std::vector<std::size_t>& column, bool by_users) {
        std::vector<double> wish = rank_;
        for (const std::size_t node : column) {
            double sum = 0.0;
            int count = 0;
            for (const Link& link : links_) {
                if ((by_users ? link.from : link.to) != node) continue;
                const double inputs = double(graph_.nodes[link.to].inputs.size());
                // Among the users of one rank the input counts.
                sum += by_users ? rank_[link.to] + 1e-3 * double(link.input) / inputs
                                : rank_[link.from];
                ++count;
            }
            if (count > 0) wish[node] = sum / count;
        }
        std::ranges::stable_sort(column, {}, [&](std::size_t node) { return wish[node]; });
        set_ranks(column);
    }

    /// Pairs of wires that cross, as far as their ends' ranks tell.
    std::size_t crossings() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < links_.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const Link &a = links_[i], &b = links_[k];
                if (column_[a.from] != column_[b.from] || column_[a.to] != column_[b.to]) continue;
                const double from = rank_[a.from] - rank_[b.from];
                const double to =
                    a.to == b.to ? double(a.input) - double(b.input) : rank_[a.to] - rank_[b.to];
                if (from * to < 0.0) ++count;
            }
        return count;
    }

    void stack() {
        for (const std::vector<std::size_t>& column : columns_) {
            double y = 0.0;
            for (const std::size_t node : column) {
                y_[node] = y;
                y += boxes_[node].height + gap_.y;
            }
            for (const std::size_t node : column) y_[node] -= 0.5 * y;
        }
    }

    /// Moves the nodes of all columns next to their users (`by_users`) or to what they are made of.
    void settle(bool by_users) {
        for (std::size_t c = 0; c < columns_.size(); ++c)
            settle_column(columns_[by_users ? c : columns_.size() - 1 - c], by_users);
    }

    /// The places of a column's nodes that are nearest to those that they wish, in the mean square,
    /// while they keep their order and distance: an isotonic regression, by pooling neighbours.
    void settle_column(const std::vector<std::size_t>& column, bool by_users) {
        struct Pool {
            double sum;
            std::size_t count;
            double mean() const { return sum / double(count); }
        };
        std::vector<double> offset;
        std::vector<Pool> pools;
        double below = 0.0;
        for (const std::size_t node : column) {
            offset.push_back(below);
            pools.push_back({wished(node, by_users) - below, 1});
            below += boxes_[node].height + gap_.y;
            while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
                const Pool last = pools.back();
                pools.pop_back();
                pools.back().sum += last.sum;
                pools.back().count += last.count;
            }
        }
        std::size_t at = 0;
        for (const Pool& pool : pools)
            for (std::size_t i = 0; i < pool.count; ++i, ++at)
                y_[column[at]] = pool.mean() + offset[at];
    }

    double input_y(const Link& link) const {
        const NodeBox& box = boxes_[link.to];
        return box.first_input + box.input_step * double(link.input);
    }

    /// Where a node would make its wires level; where it is, if it has none.
    double wished(std::size_t node, bool by_users) const {
        double sum = 0.0;
        int count = 0;
        for (const Link& link : links_) {
            if ((by_users ? link.from : link.to) != node) continue;
            sum += by_users ? y_[link.to] + input_y(link) - boxes_[node].output
                            : y_[link.from] + boxes_[link.from].output - input_y(link);
            ++count;
        }
        return count > 0 ? sum / count : y_[node];
    }

    GraphLayout places() const {
        GraphLayout layout{std::vector<Vec2d>(y_.size(), Vec2d(0.0)), Vec2d(0.0), {}};
        double x = 0.0, top = y_[nodes_.front()];
        for (const std::size_t node : nodes_) top = std::min(top, y_[node]);
        for (std::size_t c = columns_.size(); c-- > 0;) {
            double widest = 0.0;
            for (const std::size_t node : columns_[c])
                widest = std::max(widest, boxes_[node].width);
            for (const std::size_t node : columns_[c]) {
                layout.places[node] = {x, y_[node] - top};
                layout.size.y = std::max(layout.size.y, y_[node] - top + boxes_[node].height);
            }
            layout.size.x = x + widest;
            x += widest + gap_.x;
        }
        return layout;
    }

    const NodeGraph& graph_;
    const std::vector<NodeBox>& boxes_;
    const std::vector<std::size_t>& nodes_;
    Vec2d gap_;
    std::vector<Link> links_;
    std::vector<std::size_t> column_;
    std::vector<std::vector<std::size_t>> columns_;
    std::vector<double> rank_, y_;
};

}  // namespace

GraphLayout flow_layout(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
                        const std::vector<std::size_t>& nodes, const Vec2d& gap) {
    return nodes.empty() ? GraphLayout{} : FlowLayout(graph, boxes, nodes, gap).run();
}

}  // namespace burl
