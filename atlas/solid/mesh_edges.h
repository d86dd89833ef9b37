#pragma once
// The mesh's edges with the triangles on both sides, end points in the same order: seams, charts
// and mismatch are measured along them.
#include <array>
#include <cstdint>
#include <vector>

#include "atlas/solid/atlas.h"

namespace burl {

/// One triangle's side of an edge: its corners (0..2) at the edge's two ends.
struct EdgeSide {
    std::uint32_t triangle = 0;
    std::array<std::uint8_t, 2> corners{};
};

/// An edge of the mesh with one or two sides.
struct MeshEdge {
    /// The sides of the edge, with the end points in the same order; `second` only if interior.
    EdgeSide first, second;
    bool interior = false;
};

/// Every edge once, ordered by triangle and edge number of its first side.
std::vector<MeshEdge> mesh_edges(const Mesh& mesh, const Connectivity& connectivity);

/// Whether the texture goes on across an interior edge: both ends have equal places on both sides.
bool joined(const Atlas& atlas, const MeshEdge& edge);

/// Length of the edge in mesh units.
double edge_length(const Mesh& mesh, const MeshEdge& edge);

}  // namespace burl
