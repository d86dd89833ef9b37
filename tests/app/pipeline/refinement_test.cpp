// A dragged slider is answered by a level that fits the time there is, and refined at rest.
#include "app/pipeline/refinement.h"
#include "app/recipe/edit/recipe_json.h"

#include <gtest/gtest.h>

#include "tests/app/support/sample_scene.h"

namespace burl {
namespace {

TEST(LevelChoice, IsTheFinestThatFits) {
    LevelChoice choice(0.010, 5);
    EXPECT_EQ(choice.level(), 5u);
    choice.took(5, 0.0001);  // level 2 would take 0.0064 s, level 1 0.0256 s
    EXPECT_EQ(choice.level(), 2u);
    choice.took(2, 0.0024);
    EXPECT_EQ(choice.level(), 1u);
    choice.took(1, 0.001);
    EXPECT_EQ(choice.level(), 0u);
    choice.took(0, 0.011);
    EXPECT_EQ(choice.level(), 1u);
    choice.took(1, 100.0);
    EXPECT_EQ(choice.level(), 5u);
}

TEST(LevelChoice, GoesToTheFinestThatPatienceAllowsAndAlwaysOn) {
    LevelChoice choice(0.010, 5);
    choice.took(3, 0.005);  // level 1: 0.08 s, level 0: 0.32 s
    EXPECT_EQ(choice.finer_than(3, 0.1), 1u);
    EXPECT_EQ(choice.finer_than(3, 1.0), 0u);
    EXPECT_EQ(choice.finer_than(3, 0.0), 2u);
    EXPECT_EQ(choice.finer_than(1, 0.0), 0u);
    EXPECT_EQ(choice.finer_than(0, 0.0), 0u);
}

class Refinement : public testing::Test {
  protected:
    Refinement() : pipeline_(cube_mesh()) {
        pipeline_.set_cache(1 << 24);
        pipeline_.set_recipe(load_recipe("marble", {"atlas.size=64"}));
    }
    /// The levels shown, each of which must be the one that is baked.
    std::vector<std::uint32_t> shown(LevelChoice choice, SliderState slider, double patience) {
        std::vector<std::uint32_t> levels;
        Pipeline other(cube_mesh());
        other.set_recipe(pipeline_.recipe());
        const auto show = [&](std::uint32_t level, const Image<Rgb8>& picture) {
            levels.push_back(level);
            EXPECT_EQ(picture, other.synthesize<Rgb8>(level));
        };
        EXPECT_TRUE(refine<Rgb8>(pipeline_, choice, slider, patience, {}, show));
        return levels;
    }
    Pipeline pipeline_;
};

TEST_F(Refinement, ShowsOnePictureOfADragAndEndsWithTheTexture) {
    using Levels = std::vector<std::uint32_t>;
    EXPECT_EQ(shown({0.0, 3}, SliderState::moving, 0.0), Levels{3});
    EXPECT_EQ(shown({0.0, 3}, SliderState::released, 0.0), (Levels{3, 2, 1, 0}));
    EXPECT_EQ(shown({0.0, 3}, SliderState::released, 1e9), (Levels{3, 0}));
    LevelChoice fast(1e9, 3);
    fast.took(3, 1e-9);
    EXPECT_EQ(shown(fast, SliderState::released, 0.0), Levels{0});
}

TEST_F(Refinement, EndsWhereItIsStopped) {
    std::stop_source stop;
    std::vector<std::uint32_t> levels;
    LevelChoice choice(0.0, 3);
    const auto show = [&](std::uint32_t level, const Image<Rgb8>&) {
        levels.push_back(level);
        if (level == 2) stop.request_stop();
    };
    EXPECT_FALSE(
        refine<Rgb8>(pipeline_, choice, SliderState::released, 0.0, stop.get_token(), show));
    EXPECT_EQ(levels, (std::vector<std::uint32_t>{3, 2}));
}

}  // namespace
}  // namespace burl
