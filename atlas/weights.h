#pragma once
// How much texture a triangle asks for in each of the three atlases of Carr & Hart 2001, section
// 4: the same for all, its area, or its longest edge. Weights are kept with 24 bits so that every
// later comparison is blind to the mesh's unit of length.
#include <cstddef>
#include <vector>

#include "atlas/atlas.h"

namespace burl {

/// Per triangle the texel area wanted, relative to the largest (so in [0,1]): 1 for uniform, the
/// area for area, the longest edge squared for length. 0 for triangles without area.
std::vector<float> triangle_weights(const Mesh& mesh, AtlasKind kind);

/// True for a repeated point or a height below 1e-14 of the mesh's box: nothing to see of it.
/// Relative, and safe for meshes of any size.
std::vector<bool> zero_area_triangles(const Mesh& mesh);

}  // namespace burl
