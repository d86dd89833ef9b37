#pragma once
// Which triangles meet along which edge, from OpenMesh's half-edges. Faces are added one by one;
// where an edge or vertex is complex (non-manifold) the face gets vertices of its own, so no face
// is lost and ids stay the mesh's.
#include <array>
#include <cstdint>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

struct Connectivity {
    /// Per triangle and edge k (corner k to corner (k+1)%3): the triangle on the other side, or -1.
    std::vector<std::array<std::int32_t, 3>> neighbours;
    std::uint64_t interior_edges = 0;
    std::uint64_t boundary_edges = 0;  ///< edges with one face, those made by splitting included
    std::uint64_t split_faces =
        0;  ///< faces OpenMesh could only take with split vertices (complex edge or vertex)
    std::uint64_t shells = 0;  ///< components connected across edges
};

/// Neighbours are symmetric: neighbours[a][k] == b implies some j with neighbours[b][j] == a, on
/// the same two points. Degenerate triangles (a repeated point) have no neighbours.
Connectivity build_connectivity(const Mesh& mesh);

}  // namespace burl
