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

/// Compressed rows: node i's neighbours are targets[begin[i]] up to targets[begin[i+1]]. Weights
/// are whole numbers relative to the mesh, so that its scale does not matter.
struct DualGraph {
    std::vector<std::int32_t> begin, targets, edge_weights, node_weights;
    std::size_t nodes() const { return node_weights.size(); }
};

/// Cosine of the angle between the normals of triangle t and its neighbour; 1 where one has no
/// area.
double dihedral_cosine(const Mesh& mesh, std::uint32_t t, std::uint32_t neighbour);

/// Length of edge k of triangle t, in mesh units.
double edge_length(const Mesh& mesh, std::uint32_t t, std::size_t k);

/// Node i is faces[i]; `local` is scratch of one entry per mesh triangle, -1 on entry and return.
/// Nodes weigh their area. An edge weighs its length, and half of it or less across a crease:
/// length * (1 - (1 - cosine) / 2).
DualGraph dual_graph(const Mesh& mesh, const Connectivity& connectivity,
                     std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local);

/// Per node its part, 0 <= part < parts; parts may be empty or in several pieces. The same graph
/// and seed give the same parts, whatever other threads do.
std::vector<std::uint32_t> partition_graph(const DualGraph& graph, std::uint32_t parts, int seed);

/// The same with two parts of equal weight to about 0.1 %, where partition_graph allows 3 %.
std::vector<std::uint32_t> bisect_graph(const DualGraph& graph, int seed);

}  // namespace burl
