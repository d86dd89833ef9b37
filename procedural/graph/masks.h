#pragma once
// The masks that a graph reads: numbers that nodes such as `occlusion` and `curvature` take from
// the mesh's shape at the texel that is being filled, wherever in the tree they stand. A graph
// knows which masks it needs and numbers them; who fills an atlas gives their values.
#include <cstddef>
#include <string>
#include <vector>

#include "procedural/graph/planes.h"
#include "procedural/graph/table.h"
#include "procedural/numbers/dual.h"

namespace burl {

/// A number that a graph reads at every texel: a kind of mask, the node's leading parameters, which
/// decide about its values, and the component of a mask that has several.
struct GraphMask {
    MaskKind kind = MaskKind::occlusion;
    std::vector<double> numbers;
    std::size_t component = 0;
    bool operator==(const GraphMask&) const = default;
};

/// The distinct masks of all nodes, in the nodes' order: mask i is what MaskRead (program.h) calls
/// i. A graph cut short after some node has the first of them.
std::vector<GraphMask> graph_masks(const TextureGraph& graph);

/// For each mask of graph_masks whether the graph's output depends on it.
std::vector<bool> masks_read(const TextureGraph& graph, GraphOutput output);

/// The name of the first node that the graph's output depends on and that is a mask; empty where
/// there is none.
std::string first_mask_node(const TextureGraph& graph, GraphOutput output);

/// The name of the first node that the graph's output depends on and that the host alone evaluates,
/// since no shader is written of it: those of functions that other programs define. Empty where
/// there is none.
std::string first_host_node(const TextureGraph& graph, GraphOutput output);

/// The reason, as a clause, why a graph with that first mask cannot be evaluated where there are no
/// texels; empty where `node` is.
std::string no_texels_for(const std::string& node);

/// Whether the graph's output depends on a node `slope`, which needs the gradients of what it
/// reads.
bool has_slopes(const TextureGraph& graph, GraphOutput output);

/// The values of a graph's masks at points with their gradients with respect to the solid point, by
/// the masks' numbers: one for each point. Masks that are left out, or have no values, are 0.
using MaskValues = std::vector<std::vector<Dual>>;

/// The largest absolute texture coordinate that `mesh_uv` gives.
inline constexpr double farthest_uv = 65536.0;

}  // namespace burl
