#pragma once
// The solid points of all texels of a chart atlas: charts where there are charts, beside them the
// surface that goes on beyond their borders, and farther off a point of a chart near by, so that no
// lookup and no MIP level reads anything else.
#include <span>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The solid points of the texels of an atlas made by layout_charts(); `positions` are the mesh's
/// points in the space wanted. A texel whose centre lies in or on a triangle shows the first such
/// triangle. One within N/32 texels (8 at least) of a border shows what a straight walk over the
/// mesh reaches beyond it (atlas/gutter/gutters.h), up to 1.5 texels the plane of the border's
/// triangle. All others show a triangle near by, a cell's texels round its first corner. Bands of
/// rows are filled in parallel; the result does not depend on the number of threads.
SolidAtlas rasterize_charts(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions);

}  // namespace burl
