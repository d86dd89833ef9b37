#pragma once
// A mesh with fewer triangles to try partitions on, and the way a division of it comes back to the
// mesh it was made from.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

struct CoarseMesh {
    Mesh mesh;  ///< positions and triangles alone
    Connectivity connectivity;
    std::vector<std::uint32_t> nearest;  ///< per triangle of the fine mesh: a coarse one near it
};

/// Neighbours by the vertices of edges; an edge that does not have exactly one triangle on each
/// side is a border.
Connectivity connect_by_vertices(const std::vector<Triangle>& triangles);

/// At most `triangles` triangles, or as many more as edge_collapse leaves. Pure, deterministic,
/// linear.
CoarseMesh coarsen(const Mesh& mesh, const Connectivity& connectivity, std::size_t triangles);

}  // namespace burl
