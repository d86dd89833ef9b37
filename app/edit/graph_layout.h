#pragma once
// Places for the nodes of a graph, the same for the same graph, so that they need not be kept. A
// small graph flows from left to right in columns that follow the longest way to the material.
// Within a column nodes are ordered to cross few wires (Sugiyama, Tagawa, Toda 1981), and stand as
// near to the inputs that they feed as the others let them. A large graph is set like a page: every
// name of "define" flows by itself, and stands before those that use it, line by line.
#include <cstddef>
#include <vector>

#include "app/edit/node_graph.h"
#include "atlas/base/vec.h"

namespace burl {

/// The size of a node, and where its wires end, from its upper left corner down.
struct NodeBox {
    double width = 0.0, height = 0.0;
    double first_input = 0.0, input_step = 0.0, output = 0.0;
};

/// The nodes of one name, or of the material, and the frame around them.
struct GraphPart {
    std::vector<std::size_t> nodes;
    Vec2d low{0.0}, high{0.0};
};

/// The upper left corner of each node, all within [0, size].
struct GraphLayout {
    std::vector<Vec2d> places;
    Vec2d size{0.0};
    std::vector<GraphPart> parts;  ///< of a page; empty where all flows together
};

/// Gaps between columns, and between the nodes of one; and how wide a flow may be that is not set
/// as a page.
struct LayoutGaps {
    Vec2d nodes{56.0, 16.0};
    double widest_flow = 1400.0;
};

/// Lays a graph out. No two nodes overlap; where the wire between them is no name, a node is left
/// of those that use it.
GraphLayout layout_graph(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
                         const LayoutGaps& gaps = {});

}  // namespace burl
