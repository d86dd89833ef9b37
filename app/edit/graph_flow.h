#pragma once
// Nodes in columns from left to right (graph_layout.h).
#include "app/edit/graph_layout.h"

namespace burl {

/// Lays some of a graph's nodes out by the wires between them; `places` has those of all nodes, of
/// which the others' are not set.
GraphLayout flow_layout(const NodeGraph& graph, const std::vector<NodeBox>& boxes,
                        const std::vector<std::size_t>& nodes, const Vec2d& gap);

}  // namespace burl
