#pragma once
// How much texture a triangle asks for in each of the three atlases of Carr & Hart 2001, section
// 4: the same for all, its area, or its longest edge. Weights are kept with 24 bits so that every
// later comparison is blind to the mesh's unit of length.
#include <cstddef>
#include <vector>

#include "atlas/solid/atlas.h"

namespace burl {

/// Per triangle the texel area wanted, relative to the largest (so in [0,1]): 1 for uniform, the
/// area for area, the longest edge squared for length. 0 for triangles without area.
std::vector<float> triangle_weights(const Mesh& mesh, AtlasKind kind);

/// Power of two that brings the largest coordinate near 1.
double unit_scale(const Mesh& mesh);

struct TriangleAreas {
    std::vector<double> areas;  ///< per triangle in units of unit^2; 0 for nothing to see
    double unit = 1.0;          ///< mesh units, a power of two
};

/// Areas that neither overflow nor vanish, whatever the mesh's size. A triangle with a repeated
/// point, or lower than the largest coordinate's rounding (1e-15 of it), has area 0.
TriangleAreas triangle_areas(const Mesh& mesh);

}  // namespace burl
