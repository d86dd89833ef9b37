#pragma once
// The solid points of all texels of a uv atlas: charts where there are charts, and the surface
// continued over their borders everywhere else, so that no lookup and no MIP level reads anything
// else.
#include <span>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The solid points of the texels of an atlas made by layout_uvs(); `positions` are the mesh's
/// points in the space wanted. A texel whose centre lies in or on a triangle shows the first such
/// triangle. A texel without one, but touched by triangles that hold no centre at all (slivers, and
/// charts smaller than a texel), shows the point of the first of these that is nearest to its
/// centre. Every other texel goes on with the affine map of the triangle of the nearest texel that
/// has one. A texture in which no triangle touches a texel has no spans.
SolidAtlas rasterize_uv_charts(const Mesh& mesh, const Atlas& atlas,
                               std::span<const Vec3d> positions);

}  // namespace burl
