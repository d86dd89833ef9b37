#pragma once
// How far from the origin the noise nodes of a graph are evaluated: as lattice_check.h asks of the
// noise terms of a field.
#include <string>

#include "atlas/solid/solid_atlas.h"
#include "procedural/graph/graph.h"

namespace burl {

/// Throws Error(unsupported), in one sentence that begins with `name` and names the node, if a
/// noise node may have lattice coordinates beyond farthest_cell, or not finite, anywhere in a box
/// of texture coordinates. The bounds of nested mappings are those of intervals, so they may be
/// wider than what is reached.
void check_graph_lattice(const TextureGraph& graph, const Vec3d& box_sizes,
                         const std::string& name);

}  // namespace burl
