#pragma once
// The chart atlas: nearly isometric charts with free outlines, packed into the texture. Samplers
// choose the level of a texture by the longer axis of a texel's footprint, so that maps which keep
// angles and lengths are sharper at a distance than full rectangles.
#include <optional>
#include <stop_token>

#include "atlas/solid/atlas.h"

namespace burl {

/// The chart atlas of the mesh: no blocks, texel-space corners and charts. A triangle for which no
/// map was found (it has no area) lies at the place of its first point in a chart, or, where that
/// has none, at texel (0,0). Nothing when the texture cannot hold the charts, or when `stop` was
/// requested first. Pure and deterministic.
std::optional<Atlas> layout_charts(const Mesh& mesh, const Connectivity& connectivity,
                                   const AtlasOptions& options, const std::stop_token& stop = {});

}  // namespace burl
