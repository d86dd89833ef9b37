#pragma once
// The shares of the texture that triangles get in the three atlases of Carr & Hart 2001, section 4:
// equal ones, or by area, or by longest edge. Weights are kept with 24 bits so that every later
// comparison is blind to the mesh's unit of length.
#include <cstddef>
#include <vector>

#include "atlas/solid/atlas.h"

namespace burl {

/// The texel area wanted by each triangle relative to the largest, in [0,1]: 1 for `uniform`, the
/// area for `area`, the longest edge squared for `length`. 0 for triangles without area.
std::vector<float> triangle_weights(const Mesh& mesh, AtlasKind kind);

/// The power of two that scales the mesh's largest absolute coordinate into [1, 2); 1 for a mesh at
/// the origin.
double unit_scale(const Mesh& mesh);

/// Areas of a mesh's triangles in a unit of their own.
struct TriangleAreas {
    std::vector<double> areas;  ///< area of each triangle in units of unit^2; 0 for none
    double unit = 1.0;          ///< length of the unit in mesh units, a power of two
};

/// The triangles' areas, which neither overflow nor vanish, whatever the mesh's size. A triangle
/// with a repeated point, or lower than the largest coordinate's rounding (1e-15 of it), has area
/// 0.
TriangleAreas triangle_areas(const Mesh& mesh);

}  // namespace burl
