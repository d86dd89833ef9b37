#include "app/bake/expected_tasks.h"

#include <span>

#include <tbb/global_control.h>

#include "app/pipeline/material.h"
#include "app/pipeline/tasks.h"

namespace burl {

namespace {

// Of one thread, in seconds a texel (docs/lab/economy.md).
constexpr double averaging_seconds = 60e-9;  ///< of a picture's MIP levels
constexpr double encoding_seconds = 80e-9;   ///< of a picture of 8 bits
constexpr double writing_seconds = 4e-9;     ///< of a picture, by any number of threads
/// How much longer normals take than the texture, about: from 1.1 to 2.6 times.
constexpr double normals_to_texture = 1.6;

double threads_at_work(const BakePlan& plan) {
    const auto all =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return double(plan.threads > 0 ? std::size_t(plan.threads) : all);
}

}  // namespace

std::vector<ExpectedTask> expected_tasks(const BakePlan& plan, const Recipe& recipe) {
    const double texels = double(recipe.atlas.columns()) * double(recipe.atlas.rows());
    const bool has_normals = plan.normals != NormalSpace::none;
    const MaterialAsked asked = plan.material();
    const std::span<const Recipe> recipes =
        plan.sharing.empty() ? std::span(&recipe, 1) : std::span<const Recipe>(plan.sharing);
    const double pictures =
        1.0 + double(picture_names(recipes, asked).size()) + (has_normals ? 1.0 : 0.0);
    const double each = pictures * texels, one = each / threads_at_work(plan);
    return {{tasks::texture, std::nullopt},
            {tasks::levels, plan.levels.count > 0 ? averaging_seconds * one : 0.0},
            {tasks::normals, 0.0, has_normals ? normals_to_texture : 0.0},
            {tasks::pictures, encoding_seconds * one * double(plan.depth) / 8.0},
            {tasks::write, writing_seconds * each}};
}

}  // namespace burl
