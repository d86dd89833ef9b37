#pragma once
// The distance from the origin at which the noise nodes of a graph are evaluated: the counterpart
// of lattice_check.h for the noise terms of a field.
#include <string>

#include "atlas/solid/solid_atlas.h"
#include "procedural/graph/graph.h"

namespace burl {

/// Throws Error(unsupported) in one sentence, which begins with `name` and names the node, where a
/// noise node may have lattice coordinates beyond farthest_cell, or not finite ones, anywhere in a
/// box of texture coordinates whose absolute values are at most `box_sizes`. Nested mappings are
/// bounded by interval arithmetic, so the bounds may be wider than the coordinates that occur.
void check_graph_lattice(const TextureGraph& graph, const Vec3d& box_sizes,
                         const std::string& name);

}  // namespace burl
