#pragma once
// Triangle strips: runs of triangles that share edges, of which each vertex after the second adds
// one triangle. The triangles meet where they share vertices, so the cuts of an atlas end strips.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Strips of the vertices' numbers, one after the other. Triangle i of a strip is its vertices i,
/// i+1 and i+2, the last two exchanged where i is odd; triangles with a repeated vertex turn a
/// strip, and are none of the mesh's.
struct TriangleStrips {
    std::vector<std::uint32_t> vertices{};
    std::vector<std::size_t> ends{};  ///< per strip the index after its last vertex
    std::uint64_t left_out = 0;  ///< triangles with a repeated vertex, which strips cannot hold
    /// Closed runs of edges that only one triangle has.
    std::uint64_t border_loops = 0;
};

/// Parts triangles into strips: each triangle without a repeated vertex is in one of them once,
/// with its orientation. The way is greedy, after SGI's tomesh (Akeley, Haeberli, Burns 1990), as
/// Evans, Skiena and Varshney ("Optimizing triangle strips for fast rendering", 1996) describe it:
/// a strip begins where the fewest neighbours are left, in the direction of the most triangles. The
/// time grows with the number of triangles. The result depends on the arguments alone.
TriangleStrips triangle_strips(std::span<const Triangle> triangles);

/// The strips as one, joined by triangles with a repeated vertex.
std::vector<std::uint32_t> joined(const TriangleStrips& strips);

/// The counts of strips that were written.
struct StripCounts {
    std::uint64_t triangles = 0;  ///< triangles in strips
    std::uint64_t strips = 0;
    std::uint64_t indices = 0;  ///< indices written, those between strips included
    std::uint64_t border_loops = 0;
    std::uint64_t left_out = 0;

    /// Adds strips of so many triangles that were written with so many indices.
    void add(const TriangleStrips& strips, std::size_t of_triangles, std::size_t written);
};

}  // namespace burl
