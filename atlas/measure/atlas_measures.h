#pragma once
// All measures of `burl metrics` that need no texture's values, for Burl's atlases and for any
// mesh's UVs.
#include "atlas/measure/charts.h"
#include "atlas/measure/metrics.h"
#include "atlas/measure/shape.h"
#include "atlas/measure/texels.h"

namespace burl {

/// Use of the texture, charts, shapes of triangles and texels of one atlas.
struct AtlasMeasures {
    AtlasMetrics use;
    ChartMetrics charts;
    ShapeMetrics shape;
    TexelMetrics texels;
};

/// All measures of an atlas; `solid` is the atlas's own rasterisation, in any space.
AtlasMeasures measure_atlas(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid,
                            std::span<const MeshEdge> edges);

}  // namespace burl
