#include "app/bake/expected_tasks.h"

#include <algorithm>
#include <span>
#include <vector>

#include "app/bake/trial.h"
#include "app/pipeline/material.h"
#include "app/pipeline/tasks.h"

namespace burl {

namespace {

// In seconds a texel (docs/lab/economy.md).
constexpr double writing_seconds = 1e-9;     ///< of files that encoding has not written yet
constexpr double uv_point_seconds = 150e-9;  ///< of points by texture coordinates
constexpr double patch_point_seconds = 11e-9, chart_point_seconds = 20e-9;
constexpr double block_point_seconds = 0.3e-9;
constexpr double exr_seconds = 12e-9;  ///< of a band of floats
// In seconds a triangle.
constexpr double map_seconds = 14e-6;  ///< of patches and charts
constexpr double layout_seconds = 1e-6;

/// The costs of a bake too small for a trial, about; of one thread.
TrialCosts usual_costs(const BakePlan& plan, const Recipe& recipe) {
    const bool has_normals = plan.normals != NormalSpace::none;
    const MaterialAsked asked = plan.material();
    const auto pictures =
        double(1 + picture_names(std::span(&recipe, 1), asked).size() + (has_normals ? 1 : 0));
    TrialCosts costs{60e-9, 0.0, 120e-9, std::vector(std::size_t(pictures), 60e-9)};
    if (asked.levels > 0) costs.levels = 60e-9 * pictures;
    if (has_normals) costs.normal_maps = asked.rough_levels() ? 2 : 1;
    const double threads = threads_at_work(plan);
    for (double* cost : {&costs.texture, &costs.levels, &costs.normals}) *cost /= threads;
    for (double& picture : costs.pictures) picture /= threads;
    return costs;
}

TrialCosts costs_of(const BakePlan& plan, const Recipe& recipe, Pipeline& pipeline) {
    const TrialCosts costs = plan.vertex_colors ? TrialCosts() : try_costs(pipeline, recipe, plan);
    return costs.texture > 0.0 ? costs : usual_costs(plan, recipe);
}

double point_seconds(AtlasKind kind) {
    return kind == AtlasKind::uv      ? uv_point_seconds
           : kind == AtlasKind::chart ? chart_point_seconds
           : kind == AtlasKind::patch ? patch_point_seconds
                                      : block_point_seconds;
}

}  // namespace

std::vector<ExpectedTask> expected_tasks(const BakePlan& plan, const Recipe& recipe,
                                         Pipeline& pipeline) {
    const std::span<const Recipe> recipes =
        plan.sharing.empty() ? std::span(&recipe, 1) : std::span<const Recipe>(plan.sharing);
    const double texels = double(recipe.atlas.columns()) * double(recipe.atlas.rows());
    const double share = texels / double(recipes.size()), shown = usual_coverage * share;
    const AtlasKind kind = recipe.atlas.kind;
    ExpectedTask texture{tasks::texture, 0.0};
    std::vector<ExpectedTask> normals;
    std::vector<double> pictures;
    double levels = 0.0;
    std::size_t normal_maps = 0;
    for (const Recipe& one : recipes) {
        const TrialCosts costs = costs_of(plan, one, pipeline);
        const bool on_host = !pipeline.context().synthesizer;
        if (on_host) texture.seconds += shown * costs.texture;
        if (costs.normal_maps > 0) normals.push_back({tasks::normals, shown * costs.normals});
        levels += costs.levels * share;
        pictures.resize(std::max(pictures.size(), costs.pictures.size()), 0.0);
        for (std::size_t i = 0; i < costs.pictures.size(); ++i)
            pictures[i] += costs.pictures[i] * share;
        normal_maps = std::max(normal_maps, costs.normal_maps);
    }
    const double triangles = double(pipeline.mesh().triangles.size());
    const bool mapped = kind == AtlasKind::patch || kind == AtlasKind::chart;
    const double layout = mapped ? map_seconds : layout_seconds;
    std::vector<ExpectedTask> all{{tasks::layout, layout * triangles},
                                  {tasks::points, point_seconds(kind) * texels}};
    const auto add = [&](const std::vector<ExpectedTask>& some) {
        all.insert(all.end(), some.begin(), some.end());
    };
    const bool writes = !plan.paths.empty();
    const bool floats = writes && plan.kind == ImageKind::rgb_float;
    if (floats) texture.seconds += exr_seconds * texels;
    if (floats) add(normals);  // the map is a file of its own
    all.push_back(texture);
    if (plan.levels.count > 0) all.push_back({tasks::levels, levels});
    for (std::size_t i = 0; !floats && i < normal_maps; ++i) add(normals);
    if (writes && !floats)
        for (const double picture : pictures) all.push_back({tasks::pictures, picture});
    if (writes) all.push_back({tasks::write, writing_seconds * texels});
    return all;
}

}  // namespace burl
