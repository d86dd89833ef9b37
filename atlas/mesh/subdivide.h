#pragma once
// Midpoint subdivision: finer triangles on the same surface, for displacement.
#include "atlas/mesh/mesh.h"

namespace burl {

/// The mesh with every triangle split in four at the middles of its edges, `times` times over.
/// Corners between get the mean of their edge's attributes: normals at unit length, and of joints
/// the four of most weight. Triangle t becomes 4t to 4t+3. Throws Error(unsupported) where more
/// than `most` triangles would come out.
Mesh subdivided(Mesh mesh, int times, std::uint64_t most = ReadOptions{}.most_triangles);

}  // namespace burl
