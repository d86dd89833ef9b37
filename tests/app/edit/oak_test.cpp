// A material like oak built from nothing in fourteen steps, as the guide does it.
#include <gtest/gtest.h>

#include <cmath>

#include "app/edit/node_graph.h"
#include "procedural/graph/evaluator.h"
#include "tests/app/edit/edit_cases.h"
#include "tests/app/edit/oak_steps.h"

namespace burl {
namespace {

test::BuiltRecipe built() {
    return test::built_oak(load_recipe("oak"));
}

TEST(BuiltOak, TakesFourteenSteps) {
    const test::BuiltRecipe oak = built();
    EXPECT_EQ(oak.steps, 14);
    EXPECT_EQ(parse_recipe(to_json(oak.recipe), "written"), oak.recipe);
    EXPECT_EQ(node_graph(oak.recipe).nodes.size(), 12u);
}

TEST(BuiltOak, HasRingsAboutItsAxisAndPoresAlongIt) {
    const Recipe recipe = built().recipe;
    const GraphEvaluator evaluate(recipe.texture);
    const auto change = [&](const Vec3d& step) {
        double sum = 0.0;
        for (int i = 0; i < 400; ++i) {
            const double turn = 0.11 * i, r = 0.05 + 0.001 * i;
            const Vec3d p(r * std::cos(turn), r * std::sin(turn), 0.002 * i);
            sum += glm::length(evaluate(p + step).color() - evaluate(p).color());
        }
        return sum;
    };
    EXPECT_GT(change({0.01, 0, 0}), 4.0 * change({0, 0, 0.01})) << "wood is grained along z";
}

TEST(BuiltOak, ItsRoughnessFollowsItsPores) {
    const Recipe recipe = built().recipe;
    ASSERT_EQ(recipe.texture.channels.size(), 1u);
    EXPECT_EQ(recipe.texture.channels[0].channel, Channel::roughness);
    TextureGraph rough = recipe.texture, pores = recipe.texture;
    rough.result = recipe.texture.channels[0].node;
    for (const GraphName& name : recipe.texture.names)
        if (name.name == "pores") pores.result = name.uses.front().node;
    const GraphEvaluator roughness(rough), pore(pores);
    for (int i = 0; i < 50; ++i) {
        const Vec3d p(0.01 * i, 0.3 - 0.007 * i, 0.02 * i);
        EXPECT_NEAR(roughness(p).channels[0].value, 0.4 + 0.4 * pore(p).channels[0].value, 1e-12);
    }
}

}  // namespace
}  // namespace burl
