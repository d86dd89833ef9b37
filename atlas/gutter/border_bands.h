#pragma once
// The border edge of charts that each texel outside them lies nearest to in the texture. Every edge
// visits the texels of its own band only: those straight before it, and at a convex corner those
// up to the corner's bisector. So the time is linear in the texels, however many edges there are.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/base/vec.h"
#include "atlas/mesh/edge_neighbours.h"

namespace burl {

/// The triangles of a mesh, and where charts have them in the texture.
struct ChartedMesh {
    std::span<const Triangle> triangles;
    std::span<const Vec3d> positions;
    std::span<const std::array<Vec2d, 3>> corners;  ///< places in texels (Atlas::corners)
    std::span<const std::uint32_t> charts;          ///< chart of each triangle
};

/// An edge 3t+k on the border of a chart, with its ends in texels; the chart lies on its left.
struct ChartEdge {
    std::uint32_t edge = 0;
    Vec2d a{0.0}, b{0.0};

    /// The place on the edge that is nearest to q.
    Vec2d nearest(const Vec2d& q) const;
};

/// The border edge 3t+k of a mesh.
ChartEdge chart_edge(const ChartedMesh& mesh, std::uint32_t edge);

/// The edges of these triangles across which the texture does not go on: open ones, and those whose
/// other side is in another chart, or at another place (a slit). Edges without length in the
/// texture are left out. In the order of the triangles.
std::vector<ChartEdge> chart_edges(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                                   std::span<const std::uint32_t> triangles);

/// Texels [x, x + count) of row y that no chart owns.
struct TexelGap {
    std::uint32_t y = 0, x = 0, count = 0;
};

/// The owner of a texel that belongs to no chart.
inline constexpr std::uint32_t no_owner = 0xffffffffu;

/// The texels without an owner; row 0 of `owners` is row `first_row` of the texture.
std::vector<TexelGap> gaps_between(const Image<std::uint32_t>& owners, std::uint32_t first_row = 0);

/// The number in `edges` of the nearest edge to each texel of the gaps, texel by texel; no_edge
/// where none is within `reach` texels of its centre. Of edges that are as near, the one that faces
/// the texel most is taken, then the first. Gaps are ordered by row, then x, and do not overlap.
std::vector<std::uint32_t> nearest_edges(std::span<const ChartEdge> edges,
                                         std::span<const TexelGap> gaps, double reach);
inline constexpr std::uint32_t no_edge = 0xffffffffu;

}  // namespace burl
