#pragma once
// The steps of a texture's value program (procedural/graph/value_program.h) as nodes of MaterialX.
#include <string>
#include <vector>

#include "app/materialx/write/nodes.h"
#include "procedural/graph/graph.h"
#include "procedural/graph/masks.h"
#include "procedural/graph/planes.h"
#include "procedural/graph/value_program.h"

namespace burl::materialx {

/// The numbers of the graph's nodes, ascending, that are evaluated for an output and for which
/// MaterialX has no nodes, such as noises of Burl's own.
std::vector<std::uint32_t> nodes_without_equivalent(const TextureGraph& graph, GraphOutput output);

/// Adds the nodes of a graph at a point and returns its results: those of GraphValues. The graph
/// must have no nodes_without_equivalent().
std::vector<Operand> write_graph(const TextureGraph& graph, GraphOutput output,
                                 const std::vector<Operand>& point, XmlNodes& nodes);

}  // namespace burl::materialx
