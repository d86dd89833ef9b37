// Recipes at a time against closed forms, their JSON, and what is refused about keys.
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/recipe_json.h"

#include <gmock/gmock.h>

#include <cmath>

#include "app/recipe/edit/key_check.h"
#include "app/recipe/edit/leaves.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl::test {
namespace {

using testing::HasSubstr;

const std::string keyed_recipe_amplitude = "texture.input.noise.0.amplitude";
const std::string phase = "texture.input.noise.0.phase.2";

KeyTrack track(std::string path, KeyEase ease, std::vector<KeyPoint> keys) {
    return {std::move(path), ease, std::move(keys)};
}

TEST(KeyTrack, GoesThroughItsKeysAndRestsBeyondThem) {
    const std::vector<KeyPoint> keys{{0.5, 1.0}, {1.5, 3.0}, {2.0, -1.0}};
    for (const KeyEase ease : {KeyEase::linear, KeyEase::smooth}) {
        const KeyTrack t = track("x", ease, keys);
        for (const KeyPoint& key : keys) EXPECT_EQ(value_at(t, key.seconds), key.value);
        EXPECT_EQ(value_at(t, 0.0), 1.0);
        EXPECT_EQ(value_at(t, 9.0), -1.0);
        EXPECT_DOUBLE_EQ(value_at(t, 1.0), 2.0);  // the middle of both forms
    }
    EXPECT_EQ(value_at(track("x", KeyEase::linear, {{1.0, 5.0}}), 0.3), 5.0);
}

TEST(KeyTrack, IsLinearOrSmooth) {
    const KeyTrack line = track("x", KeyEase::linear, {{1.0, 2.0}, {3.0, 6.0}});
    const KeyTrack smooth = track("x", KeyEase::smooth, line.keys);
    for (int i = 0; i <= 20; ++i) {
        const double x = i / 20.0, seconds = 1.0 + 2.0 * x;
        EXPECT_NEAR(value_at(line, seconds), 2.0 + 4.0 * x, 1e-14);
        EXPECT_NEAR(value_at(smooth, seconds), 2.0 + 4.0 * (3 * x * x - 2 * x * x * x), 1e-14);
    }
    const double h = 1e-6;  // at rest in its keys
    EXPECT_LT(std::abs(value_at(smooth, 1.0 + h) - 2.0) / h, 1e-4);
    EXPECT_LT(std::abs(value_at(smooth, 3.0 - h) - 6.0) / h, 1e-4);
}

TEST(RecipeAt, IsTheRecipeWithTheNumbersOfTheTime) {
    Recipe recipe = load_recipe("fire", {"texture.input.noise.0.octaves=2"});
    recipe.paint.resize(1);
    recipe.animation.tracks = {
        track(phase, KeyEase::linear, {{0, 0}, {2, -4}}),
        track("solid.translate.1", KeyEase::linear, {{0, 1}, {2, 2}}),
        track("texture.stops.1.0", KeyEase::smooth, {{0, 0.1}, {2, 0.4}}),
        track("texture.input.noise.0.seed", KeyEase::linear, {{0, 5}, {2, 8}})};
    Recipe expected = load_recipe(
        "fire", {"texture.input.noise.0.octaves=2", phase + "=-1", "solid.translate=[0,1.25,0]",
                 fmt::format("texture.stops.1.0={}", value_at(recipe.animation.tracks[2], 0.5)),
                 "texture.input.noise.0.seed=6"});  // 5.75, rounded
    expected.paint = recipe.paint;
    EXPECT_EQ(recipe_at(recipe, 0.5), expected);
    EXPECT_EQ(recipe_at(recipe_at(recipe, 0.5), 1.0), expected);  // it has no keys any more
}

TEST(RecipeAt, LeavesRecipesWithoutKeysAlone) {
    Recipe recipe = load_recipe("marble");
    recipe.animation.seconds = 7.0;
    EXPECT_EQ(recipe_at(recipe, 3.0), recipe);
}

TEST(RecipeAt, KeepsTheImagesOfAGraph) {
    const Scratch scratch;
    const std::string path = scratch.write(
        "g.json",
        R"({"texture": {"node": "scale", "a": {"node": "warp", "input": {"node": "fbm"},
            "strength": 0.5}, "b": 0.7}})");
    Recipe recipe = load_recipe(path);
    recipe.animation.tracks = {track("texture.b", KeyEase::linear, {{0, 0}, {1, 1}}),
                               track("texture.a.strength", KeyEase::linear, {{0, 0}, {1, 2}})};
    EXPECT_EQ(recipe_at(recipe, 0.25),
              load_recipe(path, {"texture.b=0.25", "texture.a.strength=0.5"}));
    EXPECT_EQ(parse_recipe(to_json(recipe), "again"), recipe);
}

TEST(RecipeAt, SaysAtWhichTimeThereIsNoRecipe) {
    Recipe recipe = load_recipe("fire");  // whose second stop is at 0.25
    recipe.animation.tracks = {track("texture.stops.0.0", KeyEase::linear, {{0, 0}, {1, 1}})};
    EXPECT_NO_THROW(recipe_at(recipe, 0.25));
    try {
        recipe_at(recipe, 0.5);
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("keys at 0.5 s: texture.stops.1.0 is 0.25"));
    }
}

TEST(Frames, CoverTheAnimationFromItsStartToItsEnd) {
    KeyedAnimation animation{.seconds = 2.0, .rate = 12, .loop = false, .tracks = {}};
    ASSERT_EQ(frame_count(animation), 25);
    for (int i = 0; i < 25; ++i) EXPECT_DOUBLE_EQ(frame_seconds(animation, i, 25), i / 12.0);
    EXPECT_EQ(frame_seconds(animation, 24, 25), 2.0);
    animation.loop = true;
    ASSERT_EQ(frame_count(animation), 24);
    for (int i = 0; i < 24; ++i) EXPECT_DOUBLE_EQ(frame_seconds(animation, i, 24), i / 12.0);
    animation.seconds = 0.01;
    EXPECT_EQ(frame_count(animation), 2);
}

std::string wrong_keys(const std::string& animation) {
    try {
        parse_recipe(
            R"({"texture": {"input": {"noise": [{"gain": 0.5}]}}, "animation": )" + animation + "}",
            "r.json");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(AnimationJson, ComesBack) {
    const std::string json = R"({"texture": {"input": {"noise": [{}]}}, "animation": {
        "seconds": 3.5, "rate": 30, "end": "loop", "tracks": [
            {"path": "solid.scale", "ease": "smooth", "keys": [[0, 1], [1.5, 2.25]]},
            {"path": "texture.input.noise.0.phase.0", "keys": [[0.5, -3]]}]}})";
    const Recipe recipe = parse_recipe(json, "r.json");
    const KeyedAnimation expected{
        .seconds = 3.5,
        .rate = 30,
        .loop = true,
        .tracks = {track("solid.scale", KeyEase::smooth, {{0, 1}, {1.5, 2.25}}),
                   track("texture.input.noise.0.phase.0", KeyEase::linear, {{0.5, -3}})}};
    EXPECT_EQ(recipe.animation, expected);
    EXPECT_EQ(parse_recipe(to_json(recipe), "again"), recipe);
    EXPECT_EQ(to_json(Recipe{}).find("animation"), std::string::npos);
}

TEST(AnimationJson, SaysWhatIsWrong) {
    EXPECT_EQ(wrong_keys(R"({"tracks": [{"path": "solid.scale", "keys": [[0, 1]]}]})"), "");
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "solid.scal", "keys": [[0, 1]]}]})"),
                HasSubstr("did you mean \"solid.scale\"?"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "atlas.size", "keys": [[0, 64]]}]})"),
                HasSubstr("none of its atlas"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "solid.rotate", "keys": [[0, 64]]}]})"),
                HasSubstr("solid.rotate.0"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "texture.wrap", "keys": [[0, 1]]}]})"),
                HasSubstr("one number"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"keys": [[0, 1]]}]})"), HasSubstr("path is missing"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "solid.scale"}]})"),
                HasSubstr("keys is missing"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "solid.scale", "keys": []}]})"),
                HasSubstr("must have at least one key"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "solid.scale", "keys": [[1, 1], [1, 2]]}]})"),
                HasSubstr("keys.1.0 is 1, must be later than the key before it, 1"));
    EXPECT_THAT(
        wrong_keys(R"({"tracks": [{"path": "texture.input.noise.0.gain", "keys": [[0, 3]]}]})"),
        HasSubstr("keys.0.1 is 3, must be from 0 to 2 as texture.input.noise.0.gain"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "solid.scale", "keys": [[0, 1]]},
                                     {"path": "solid.scale", "keys": [[0, 1]]}]})"),
                HasSubstr("another one than that of animation.tracks.0"));
    EXPECT_THAT(wrong_keys(R"({"tracks": [{"path": "solid.scale", "keys": [[-1, 1]]}]})"),
                HasSubstr("keys.0.0 is -1"));
    EXPECT_THAT(wrong_keys(R"({"second": 1})"), HasSubstr("did you mean \"seconds\"?"));
    EXPECT_THAT(wrong_keys(R"({"end": "bounce"})"), HasSubstr("\"stop\", \"loop\""));
}

TEST(RecipeNumbers, AreThoseThatSettingsTake) {
    const Recipe recipe = load_recipe("cloudy-planet");
    const Json json = slider_json(recipe);
    const std::vector<RecipeNumber> numbers = recipe_numbers(json);
    EXPECT_GT(numbers.size(), 40u);
    std::vector<std::string> settings;
    for (const RecipeNumber& number : numbers) {
        settings.push_back(fmt::format("{}={}", number.path, number.value));
        EXPECT_TRUE(number.parameter) << number.path;
    }
    EXPECT_EQ(with_numbers(recipe, settings), recipe);
    EXPECT_TRUE(find_number(json, "solid.rotate.2"));
    EXPECT_FALSE(find_number(json, "solid.rotate"));
    EXPECT_FALSE(find_number(json, "atlas.size"));
    EXPECT_FALSE(find_number(json, "name"));
}

TEST(KeyedBake, StillsAreThoseOfTheTimeAndFramesThoseOfAllTimes) {
    const Scratch scratch;
    const std::string mesh =
        scratch.write("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    const std::string keyed = scratch.write("r.json", R"({"texture": {"input": {"noise": [{}]}},
        "animation": {"seconds": 2, "tracks": [{"path": "solid.scale", "keys": [[0, 1], [2, 5]]}]}})");
    const std::string plain = scratch.write("p.json", R"({"texture": {"input": {"noise": [{}]}}})");
    const auto bake = [&](const std::string& out, const std::string& options) {
        const Outcome outcome = run_burl(
            scratch, fmt::format("bake '{}' -o '{}' -s 64 {}", mesh, scratch / out, options));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return slurp(scratch / out);
    };
    const auto at_scale = [&](int scale) {
        return bake("s.png", fmt::format("-r '{}' --set solid.scale={}", plain, scale));
    };
    EXPECT_EQ(bake("0.png", fmt::format("-r '{}'", keyed)), at_scale(1));
    EXPECT_EQ(bake("t.png", fmt::format("-r '{}' --time 0.5", keyed)), at_scale(2));
    bake("f.png", fmt::format("-r '{}' --frames 3", keyed));
    bake("l.png", fmt::format("-r '{}' --frames 4 --loop", keyed));
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(slurp(scratch / fmt::format("f.000{}.png", i + 1)), at_scale(1 + 2 * i)) << i;
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(slurp(scratch / fmt::format("l.000{}.png", i + 1)), at_scale(1 + i)) << i;
    const Outcome both =
        run_burl(scratch, fmt::format("bake '{}' -o '{}' -r '{}' --frames 3 --animate "
                                      "solid.scale=1:2",
                                      mesh, scratch / "b.png", keyed));
    EXPECT_EQ(both.exit_code, 1);
    EXPECT_THAT(both.err, HasSubstr("has keys for that number"));
}

}  // namespace
}  // namespace burl::test
