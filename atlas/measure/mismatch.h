#pragma once
// Seams as a viewer sees them: the difference between lookups of a point of an edge from its two
// sides (Purnomo, Cohen, Kumar, "Seamless Texture Atlases", 2004: zero in a seamless atlas).
#include <span>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/solid/mesh_edges.h"

namespace burl {

/// Places on both sides of points that are spread evenly by length over the seams: the interior
/// edges whose sides have different places.
struct SeamPoints {
    std::vector<std::array<Vec2d, 2>> places;  ///< places of the points in texels of level 0
    double share = 0.0;                        ///< length of the seams over all interior edges
};

/// `count` points on the seams, one at random in each of `count` equal shares of their length;
/// empty without seams.
SeamPoints seam_points(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges,
                       std::size_t count, std::uint64_t seed);

/// RMS difference of bilinear lookups in `level` from the two sides, over all interior edges by
/// length: sqrt(share) times that over `points`. `size` is the side of level 0 in texels.
double mismatch(const SeamPoints& points, const Image<Vec3f>& level, std::uint32_t size);

}  // namespace burl
