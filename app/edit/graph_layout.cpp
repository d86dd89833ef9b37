#include "app/edit/graph_layout.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "app/edit/graph_flow.h"

namespace burl {

namespace {

constexpr double page_aspect = 2.7;  // a page's width by its height, as far as its parts let it
constexpr double frame = 12.0;       // around a part
constexpr int widths_tried = 40;

/// The number of the part that a node belongs to: that of its name's node, or 0, the material's.
std::vector<std::size_t> parts_of(const NodeGraph& graph) {
    std::vector<std::size_t> part(graph.nodes.size(), 0);
    // The nodes of a name come right after its own, and names after all else.
    std::size_t now = 0;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        if (!graph.nodes[i].name.empty()) now = i;
        part[i] = now;
    }
    return part;
}

/// Parts in an order in which each comes after those that it uses; those that nothing uses come
/// last.
class PartOrder {
  public:
    explicit PartOrder(const NodeGraph& graph) : graph_(graph), part_(parts_of(graph)) {
        visit(0);
        for (std::size_t i = 0; i < part_.size(); ++i) visit(part_[i]);
    }

    std::vector<GraphPart> parts;

  private:
    void visit(std::size_t part) {
        if (std::ranges::count(seen_, part) > 0) return;
        seen_.push_back(part);
        GraphPart own;
        for (std::size_t i = 0; i < part_.size(); ++i) {
            if (part_[i] != part) continue;
            own.nodes.push_back(i);
            for (const GraphInput& input : graph_.nodes[i].inputs)
                if (input.from && part_[*input.from] != part) visit(part_[*input.from]);
        }
        parts.push_back(std::move(own));
    }

    const NodeGraph& graph_;
    std::vector<std::size_t> part_, seen_;
};

/// Sets parts line by line, in lines of this width at most; returns the page's size.
Vec2d set_lines(std::vector<GraphPart>& parts, double width, const Vec2d& gap) {
    Vec2d at(0.0), size(0.0);
    double height = 0.0;
    for (GraphPart& part : parts) {
        const Vec2d own = part.high - part.low;
        if (at.x > 0.0 && at.x + own.x > width) {
            at = {0.0, at.y + height + gap.y};
            height = 0.0;
        }
        part.low = at;
        part.high = at + own;
        size = glm::max(size, part.high);
        at.x += own.x + gap.x;
        height = std::max(height, own.y);
    }
    return size;
}

/// Sets parts on a page that is as near to page_aspect as it can be.
Vec2d set_page(std::vector<GraphPart>& parts, const Vec2d& gap) {
    double widest = 0.0, all = 0.0, best = 0.0, best_width = 0.0;
    for (const GraphPart& part : parts) {
        widest = std::max(widest, part.high.x - part.low.x);
        all += part.high.x - part.low.x + gap.x;
    }
    for (int i = 0; i <= widths_tried; ++i) {
        const double width = widest + (all - widest) * double(i) / widths_tried;
        const Vec2d size = set_lines(parts, width, gap);
        const double zoom = std::min(page_aspect / size.x, 1.0 / size.y);
        if (zoom <= best) continue;
        best = zoom;
        best_width = width;
    }
    return set_lines(parts, best_width, gap);
}

GraphLayout page_layout(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
                        const Vec2d& gap) {
    GraphLayout page{std::vector<Vec2d>(graph.nodes.size(), Vec2d(0.0)), Vec2d(0.0), {}};
    page.parts = PartOrder(graph).parts;
    std::vector<GraphLayout> flows;
    for (GraphPart& part : page.parts) {
        flows.push_back(flow_layout(graph, boxes, part.nodes, gap));
        part.high = flows.back().size + Vec2d(2.0 * frame);
    }
    page.size = set_page(page.parts, Vec2d(gap.y + 8.0));
    for (std::size_t i = 0; i < flows.size(); ++i)
        for (const std::size_t node : page.parts[i].nodes)
            page.places[node] = page.parts[i].low + Vec2d(frame) + flows[i].places[node];
    return page;
}

}  // namespace

GraphLayout layout_graph(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
                         const LayoutGaps& gaps) {
    if (graph.nodes.empty()) return {};
    std::vector<std::size_t> all(graph.nodes.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    GraphLayout flow = flow_layout(graph, boxes, all, gaps.nodes);
    const auto is_named = [](const GraphNodeView& node) { return !node.name.empty(); };
    if (flow.size.x <= gaps.widest_flow || std::ranges::none_of(graph.nodes, is_named)) return flow;
    return page_layout(graph, boxes, gaps.nodes);
}

}  // namespace burl
