#pragma once
// Everything `burl metrics` measures without looking at a texture's values, for our atlases and for
// anyone's UVs.
#include "atlas/metric_charts.h"
#include "atlas/metric_shape.h"
#include "atlas/metric_texels.h"
#include "atlas/metrics.h"

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
