#pragma once
// Places for the nodes of a graph in columns from left to right: the same for the same graph, so
// that they need not be kept. Columns follow the longest way to the material; within a column nodes
// are ordered to cross few wires (Sugiyama, Tagawa, Toda 1981), and stand as near to the inputs
// that they feed as the others let them.
#include <vector>

#include "app/edit/node_graph.h"
#include "atlas/base/vec.h"

namespace burl {

/// The size of a node, and where its wires end, from its upper left corner down.
struct NodeBox {
    double width = 0.0, height = 0.0;
    double first_input = 0.0, input_step = 0.0, output = 0.0;
};

/// The upper left corner of each node, all within [0, size].
struct GraphLayout {
    std::vector<Vec2d> places;
    Vec2d size{0.0};
};

/// Lays a graph out, with gaps between columns and between the nodes of one. No two nodes overlap,
/// and every node is left of all that use it.
GraphLayout layout_graph(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
                         const Vec2d& gap);

}  // namespace burl
