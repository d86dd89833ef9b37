#pragma once
// Texels outside charts, filled with the surface that goes on beyond the charts' borders. Each
// shows the point that a straight walk over the mesh reaches (atlas/gutter/unfolding.h) which
// leaves the nearest border edge where it is nearest, in the direction and over the length that the
// map of the edge's triangle gives the way from there to the texel. While texels walk out of one
// edge into one unfolded triangle they share an affine map, so gutters are spans as well.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/gutter/border_bands.h"
#include "atlas/gutter/unfolding.h"
#include "atlas/solid/solid_atlas.h"

namespace burl {

/// A rectangle of texels in which maps are anchored.
struct TexelBox {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// Texels [x, x + count) of row y, shown by `maps[map]` of the gutter.
struct GutterRun {
    std::uint32_t y = 0, x = 0, count = 0, map = 0;
};

/// The filled texels.
struct Gutter {
    std::vector<GutterRun> runs;  ///< in the order of the gaps
    std::vector<TexelMap> maps;
    std::vector<std::uint32_t> triangles;  ///< triangle of the border edge that each map continues
};

/// How gutters are filled.
struct GutterOptions {
    double reach = 1.0;  ///< distance from the border, in texels, up to which texels are filled
    /// The distance up to which texels go on with the plane of the border's triangle, so that
    /// bilinear lookups on the chart's side of a crease mix points of that side only.
    double own_plane = 0.0;
    AtOpenEdge at_open_edge = AtOpenEdge::end;
    int longest_walk = burl::longest_walk;  ///< triangles at which a walk ends as at an open edge
    bool leaves_open = false;  ///< whether texels stay in no run whose walk an open edge ends
};

/// Whether two maps show the same point at a texel, within 10^-6 of a step from texel to texel.
bool same_point(const TexelMap& a, const TexelMap& b, std::uint32_t x, std::uint32_t y);

/// Fills the gaps' texels from the border edges given; texels beyond reach stay in no run. Where
/// a walk ends at an open edge, its last triangle's plane goes on. Time is linear in the texels and
/// in the triangles walked over. Throws nothing; triangles without area are walked over or, at the
/// border, continued by their own constant map.
Gutter fill_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                   std::span<const ChartEdge> edges, std::span<const TexelGap> gaps,
                   const TexelBox& box, const GutterOptions& options);

/// Fills gaps whose texels have these nearest edges, as nearest_edges() found them.
Gutter fill_gutter(const ChartedMesh& mesh, const EdgeNeighbours& neighbours,
                   std::span<const ChartEdge> edges, std::span<const TexelGap> gaps,
                   std::span<const std::uint32_t> nearest, const TexelBox& box,
                   const GutterOptions& options);

}  // namespace burl
