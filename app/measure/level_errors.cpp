#include "app/measure/level_errors.h"

#include <algorithm>

#include "app/measure/metric_texture.h"
#include "app/measure/normal_error.h"
#include "atlas/measure/surface_points.h"

namespace burl {

SurfaceTruth level_truth(Pipeline& pipeline, std::uint32_t first, std::uint32_t last,
                         std::size_t points) {
    const Mesh& mesh = pipeline.mesh();
    const MetricTexture texture = recipe_texture(pipeline.recipe(), mesh);
    TruthOptions options;
    options.size = pipeline.recipe().atlas.size;
    options.detail = texture.detail;
    options.first_level = first;
    options.levels = last;
    options.level_points = points;
    options.points = options.grazing_points = 0;
    options.grazing_levels = 0;
    SurfaceTruth truth = surface_truth(normalised(mesh), texture.color, options);
    truth.level_points = refined_points(mesh, pipeline.mesh_atlas(), std::move(truth.level_points));
    return truth;
}

std::vector<double> level_errors(const Atlas& atlas, std::span<const Image<RgbF>> levels,
                                 const SurfaceTruth& truth) {
    std::vector<double> errors;
    for (std::size_t l = 0; l < std::min(levels.size(), truth.levels.size()); ++l) {
        const std::vector<Vec3d>& means = truth.levels[l].means;
        errors.push_back(
            means.empty() ? 0.0
                          : lookup_rmse(atlas, components(levels[l]), truth.level_points, means));
    }
    return errors;
}

}  // namespace burl
