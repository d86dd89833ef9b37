#pragma once
// Seams as one sees them: the same point of an edge looked up from its two sides (as in Purnomo,
// Cohen, Kumar, "Seamless Texture Atlases", 2004: zero in a seamless atlas).
#include <span>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/mesh_edges.h"

namespace burl {

/// Places on both sides of points spread evenly by length over edges whose sides differ.
struct SeamPoints {
    std::vector<std::array<Vec2d, 2>> places;  ///< level 0 texels
    double share = 0.0;                        ///< length of these edges over all interior edges
};

SeamPoints seam_points(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges,
                       std::size_t count, std::uint64_t seed);

/// RMS difference over all edges between two triangles: sqrt(share) times that over `points`.
double mismatch(const SeamPoints& points, const Image<Vec3f>& level, std::uint32_t size);

}  // namespace burl
