#pragma once
// Everything `burl metrics` measures without looking at a texture's values, for our atlases and for
// anyone's UVs.
#include "atlas/measure/charts.h"
#include "atlas/measure/metrics.h"
#include "atlas/measure/shape.h"
#include "atlas/measure/texels.h"

namespace burl {

struct AtlasMeasures {
    AtlasMetrics use;
    ChartMetrics charts;
    ShapeMetrics shape;
    TexelMetrics texels;
};

/// `solid` is the atlas's own rasterisation, in any space.
AtlasMeasures measure_atlas(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid,
                            std::span<const MeshEdge> edges);

}  // namespace burl
