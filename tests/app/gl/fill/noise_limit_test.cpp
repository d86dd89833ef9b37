// Graphs of more noises than OpenGL is given.
#include "procedural/graph/noise_count.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/base/embedded.h"
#include "app/gl/fill/synthesize.h"
#include "app/recipe/edit/recipe_json.h"
#include "tests/app/gl/device/fixture.h"
#include "tests/procedural/graph/cases.h"

namespace burl {
namespace {

using NoiseLimitTest = GlTest;

TEST(NoisesOfPresets, AreAFifthOfTheMost) {
    std::size_t most = 0;
    for (const EmbeddedFile& preset : embedded_recipes()) {
        const std::string name(preset.name.substr(0, preset.name.rfind('.')));
        const Recipe recipe = load_recipe(name);
        std::size_t noises = graph_noises(recipe.texture, GraphOutput::planes);
        if (!recipe.bump.empty())
            noises = std::max(noises, graph_noises(recipe.bump.input, GraphOutput::color));
        EXPECT_LE(5 * noises, most_shader_noises) << name;
        most = std::max(most, noises);
    }
    EXPECT_GE(most, 8u);
}

TEST_F(NoiseLimitTest, TooManyNoisesAreRefused) {
    std::string sum = R"({"node": "fbm", "octaves": 16})";
    for (int i = 1; i < 17; ++i)
        sum = fmt::format(
            R"({{"node": "add", "a": {}, "b": {{"node": "fbm", "octaves": 16, "seed": {}}}}})", sum,
            100 * i);
    EXPECT_EQ(GlSynthesis(*context).problem(graph_of(sum)),
              "its graph evaluates 272 noises for a texel, and OpenGL is given 256");
}

}  // namespace
}  // namespace burl
