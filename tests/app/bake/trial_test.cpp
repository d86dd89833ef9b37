// What a trial says of a bake's costs, and in which order tasks are expected.
#include "app/bake/trial.h"

#include <gtest/gtest.h>

#include "app/bake/expected_tasks.h"
#include "app/pipeline/tasks.h"
#include "app/recipe/edit/recipe_json.h"
#include "app/surface/sample_meshes.h"

namespace burl {
namespace {

struct Trial {
    Pipeline pipeline{sample_mesh("sample:torus")};
    BakePlan plan{};
    Recipe recipe;

    Trial(const std::string& name, std::uint32_t size) : recipe(load_recipe(name)) {
        plan.paths = {"a.png"}, plan.threads = 1;
        if (!recipe.bump.empty()) plan.normals = NormalSpace::tangent;
        recipe.atlas.size = size;
    }
    TrialCosts costs() { return try_costs(pipeline, recipe, plan); }
};

TEST(Trial, FindsThatACostlyRecipeTakesLonger) {
    const TrialCosts plain = Trial("noise", 4096).costs(), bumps = Trial("concrete", 4096).costs();
    EXPECT_GT(plain.texture, 0.0);
    ASSERT_EQ(plain.pictures.size(), 1u);
    EXPECT_GT(plain.pictures[0], 0.0);
    EXPECT_EQ(plain.normals, 0.0);
    EXPECT_EQ(plain.normal_maps, 0u);
    EXPECT_GT(bumps.texture, 10.0 * plain.texture);
    EXPECT_GT(bumps.normals, 10.0 * plain.texture);
    EXPECT_EQ(bumps.normal_maps, 1u);
    EXPECT_EQ(bumps.pictures.size(), 3u) << "colour, normals, numbers";
}

TEST(Trial, IsNearTheTimeOfTheBake) {
    Trial trial("concrete", 2048);
    const TrialCosts costs = trial.costs();
    trial.pipeline.set_threads(1);
    trial.pipeline.set_recipe(trial.recipe);
    bake_material(trial.pipeline, trial.plan.material());
    const StageRecord& made = trial.pipeline.records()[Stage::synthesis];
    const double texels = double(made.done.work.texels);
    // The bake's time is that of a clock, which other programs make longer.
    EXPECT_LT(costs.texture, 2.0 * made.seconds / texels);
    EXPECT_GT(costs.texture, 0.1 * made.seconds / texels);
}

TEST(Trial, IsLeftOutWhereTheBakeIsSmall) {
    EXPECT_EQ(Trial("concrete", 1024).costs().texture, 0.0);
}

std::vector<std::string_view> names_of(Trial trial) {
    std::vector<std::string_view> names;
    for (const ExpectedTask& task : expected_tasks(trial.plan, trial.recipe, trial.pipeline))
        names.push_back(task.task);
    return names;
}

TEST(ExpectedTasks, AreThoseOfTheBakeInItsOrder) {
    using Names = std::vector<std::string_view>;
    EXPECT_EQ(names_of({"noise", 64}),
              (Names{tasks::layout, tasks::points, tasks::texture, tasks::pictures, tasks::write}));
    Trial levels("concrete", 64);
    levels.plan.levels.count = 6;
    EXPECT_EQ(
        names_of(std::move(levels)),
        (Names{tasks::layout, tasks::points, tasks::texture, tasks::levels, tasks::normals,
               tasks::normals, tasks::pictures, tasks::pictures, tasks::pictures, tasks::write}));
    Trial floats("concrete", 64);
    floats.plan.kind = ImageKind::rgb_float;
    EXPECT_EQ(names_of(std::move(floats)),
              (Names{tasks::layout, tasks::points, tasks::normals, tasks::texture, tasks::write}));
}

}  // namespace
}  // namespace burl
