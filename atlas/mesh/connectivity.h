#pragma once
// Adjacency of triangles across edges, from OpenMesh's half-edges, and disjoint sets to join them.
// Faces are added one by one; where an edge or vertex is complex (non-manifold) the face gets
// vertices of its own, so no face is lost and ids stay the mesh's.
#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Neighbours of all triangles, and counts of edges and shells.
struct Connectivity {
    /// neighbours[t][k] is the triangle across edge k of triangle t (from corner k to corner
    /// (k+1)%3), or -1.
    std::vector<std::array<std::int32_t, 3>> neighbours;
    std::uint64_t interior_edges = 0;  ///< edges with two faces
    std::uint64_t boundary_edges = 0;  ///< edges with one face, those made by splitting included
    /// Number of faces that OpenMesh takes only with vertices of their own (complex edge or
    /// vertex).
    std::uint64_t split_faces = 0;
    std::uint64_t shells = 0;  ///< components of triangles connected across edges
    /// One label a triangle, where cut_between() cut the connectivity; else none.
    std::vector<std::uint32_t> labels;
};

/// The mesh's connectivity. Neighbours are symmetric: neighbours[a][k] == b implies some j with
/// neighbours[b][j] == a, on the same two points. Degenerate triangles (a repeated point) have no
/// neighbours.
Connectivity build_connectivity(const Mesh& mesh);

/// Cuts the mesh's connectivity between triangles with different labels, one per triangle, which
/// are no neighbours then: their edge counts as two edges with one face. Does nothing without
/// labels.
void cut_between(Connectivity& connectivity, const Mesh& mesh,
                 std::span<const std::uint32_t> labels);

/// Disjoint sets (union-find); the smallest member stands for its set.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t i, std::uint32_t j) {
        i = find(i), j = find(j);
        parent_[std::max(i, j)] = std::min(i, j);
    }

  private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace burl
