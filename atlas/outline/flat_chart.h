#pragma once
// A part of a mesh that is laid flat.
#include <cstdint>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// A flattened part of the mesh.
struct FlatChart {
    std::vector<std::uint32_t> faces;  ///< triangles of the mesh
    std::vector<Triangle> triangles;   ///< vertices of each of them, as numbers of `places`
    std::vector<Vec2d> places;         ///< place of each vertex, in units of the mesh
    std::vector<Vec2d> outline;        ///< outer border, counter-clockwise
    double area = 0.0;                 ///< area of the triangles on the mesh
};

}  // namespace burl
