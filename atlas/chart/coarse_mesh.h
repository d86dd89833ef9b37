#pragma once
// A mesh with fewer triangles to try partitions on, and the way back of a division to the fine
// mesh.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A coarse mesh with its relation to the fine one.
struct CoarseMesh {
    Mesh mesh;  ///< positions and triangles alone
    Connectivity connectivity;
    std::vector<std::uint32_t> nearest;  ///< coarse triangle near each fine one
};

/// Connectivity by equal vertices of edges; an edge that does not have exactly one triangle on each
/// side is a border. Sets the neighbours only.
Connectivity connect_by_vertices(const std::vector<Triangle>& triangles);

/// The mesh with at most `triangles` triangles, or as many more as collapse_edges() leaves. Pure,
/// deterministic, linear.
CoarseMesh coarsen(const Mesh& mesh, const Connectivity& connectivity, std::size_t triangles);

}  // namespace burl
