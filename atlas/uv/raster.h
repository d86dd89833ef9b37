#pragma once
// The solid points of all texels of a uv atlas: charts where there are charts, and the surface
// continued over their borders everywhere else, so that no lookup and no MIP level reads anything
// else.
#include <span>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The solid points of the texels of an atlas made by layout_uvs(); `positions` are the mesh's
/// points in the space wanted. A texel whose centre lies in or on a triangle shows the first such
/// triangle. Every other texel belongs to the nearest border (exactly the nearest up to
/// `exact_reach` texels away). The triangle's map goes on by at most one texel, and no further than
/// the triangle is high: so slivers and charts smaller than a texel show themselves. Beyond that,
/// up to the larger of `exact_reach` and N / 64 texels, the surface goes on across the border
/// (atlas/gutter/gutters.h). Where there is none, or farther away, the point at which the map
/// stopped is shown, and beyond one and a half texels the border's own.
/// Without a triangle in the texture there are no spans.
SolidAtlas rasterize_uv_charts(const Mesh& mesh, const Atlas& atlas,
                               std::span<const Vec3d> positions);

/// Texels from a chart up to which the nearest border is searched for among all; beyond, among
/// those of the nearest texels that have one.
inline constexpr double exact_reach = 8.0;

}  // namespace burl
