#include "atlas/measure/atlas_measures.h"

namespace burl {

AtlasMeasures measure_atlas(const Mesh& mesh, const Atlas& atlas, const SolidAtlas& solid,
                            std::span<const MeshEdge> edges) {
    AtlasMeasures all;
    all.use = measure(mesh, atlas, solid);
    all.charts = measure_charts(mesh, atlas, edges);
    all.shape = measure_shape(mesh, atlas, all.charts.of_triangle, all.charts.count);
    all.texels = measure_texels(atlas);
    return all;
}

}  // namespace burl
