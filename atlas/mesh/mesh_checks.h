#pragma once
// Counts of faces that are kept but may surprise: without area, or there twice.
#include <cstdint>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Number of triangles with a repeated point or an area of at most zero_area (mesh_builder.h) times
/// the squared longest side of the bounding box.
std::uint64_t count_degenerate_triangles(const Mesh& mesh);

/// Number of triangles on the same three points, in whatever order, as an earlier one.
std::uint64_t count_duplicate_triangles(const Mesh& mesh);

}  // namespace burl
