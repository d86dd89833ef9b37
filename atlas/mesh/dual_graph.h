#pragma once
// The graph whose nodes are triangles and whose edges are the mesh edges between them, and its
// division into parts of equal area along short borders and creases: multilevel k-way partition
// (Karypis & Kumar, "Multilevel k-way partitioning scheme for irregular graphs", 1998; METIS).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/connectivity.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A graph in compressed sparse rows (CSR): the neighbours of node i are targets[begin[i]] to
/// targets[begin[i+1] - 1], with edge_weights parallel to targets. Weights are whole numbers
/// relative to the mesh, so that its scale does not matter.
struct DualGraph {
    std::vector<std::int32_t> begin, targets, edge_weights, node_weights;
    std::size_t nodes() const { return node_weights.size(); }
};

/// Cosine of the angle between the normals of triangle t and its neighbour; 1 where one of them has
/// no area.
double dihedral_cosine(const Mesh& mesh, std::uint32_t t, std::uint32_t neighbour);

/// Length of edge k of triangle t, in mesh units.
double edge_length(const Mesh& mesh, std::uint32_t t, std::size_t k);

/// The dual graph of `faces`; node i is triangle faces[i]. `local` is scratch memory with one entry
/// per mesh triangle, -1 on entry and on return. A node weighs its area. An edge weighs its length
/// times (1 + cosine) / 2 by dihedral_cosine(): half of it at a right-angled crease, nearly nothing
/// at a fold.
DualGraph dual_graph(const Mesh& mesh, const Connectivity& connectivity,
                     std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local);

/// The part of each node, 0 <= part < parts; parts may be empty or in several pieces. The same
/// graph and seed give the same parts, whatever other threads do.
std::vector<std::uint32_t> partition_graph(const DualGraph& graph, std::uint32_t parts, int seed);

/// The part, 0 or 1, of each node in a bisection into parts of equal weight to about 0.1 %, where
/// partition_graph() allows 3 %. The same graph and seed give the same parts.
std::vector<std::uint32_t> bisect_graph(const DualGraph& graph, int seed);

}  // namespace burl
