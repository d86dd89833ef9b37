// Edits of keys, and edits of what is seen at a time: what comes of them at that time and at
// others.
#include "app/recipe/edit/key_edit.h"
#include "app/recipe/edit/recipe_json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "app/editor/session/session.h"
#include "app/recipe/edit/key_check.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/leaves.h"

namespace burl {
namespace {

const std::string amplitude = "texture.input.noise.0.amplitude";

KeyedAnimation animation_of(std::vector<KeyPoint> keys) {
    KeyedAnimation animation{.seconds = 2.0, .rate = 10, .loop = false, .tracks = {}};
    animation.tracks.push_back({amplitude, KeyEase::linear, std::move(keys)});
    return animation;
}

std::vector<KeyPoint> keys_of(const KeyedAnimation& animation) {
    const KeyTrack* track = find_track(animation, amplitude);
    return track ? track->keys : std::vector<KeyPoint>{};
}

TEST(KeyEdit, AKeyIsInsertedInOrderOrReplacesThatOfItsFrame) {
    KeyedAnimation animation =
        with_key({.seconds = 2, .rate = 10, .loop = false, .tracks = {}}, amplitude, 1.0, 0.5);
    animation = with_key(animation, amplitude, 0.2, 0.1);
    animation = with_key(animation, amplitude, 1.5, 0.7);
    EXPECT_EQ(keys_of(animation), (std::vector<KeyPoint>{{0.2, 0.1}, {1.0, 0.5}, {1.5, 0.7}}));
    EXPECT_EQ(keys_of(with_key(animation, amplitude, 1.04, 9.0))[1], (KeyPoint{1.0, 9.0}));
    EXPECT_EQ(keys_of(with_key(animation, amplitude, 1.06, 9.0)).size(), 4u);
    EXPECT_EQ(with_key(animation, "solid.scale", 0.0, 1.0).tracks.size(), 2u);
}

TEST(KeyEdit, AMovedKeyStaysOnFramesAndBetweenItsNeighbours) {
    const KeyedAnimation animation = animation_of({{0.0, 1}, {1.0, 2}, {1.5, 3}});
    const auto moved = [&](std::size_t key, double to) {
        return keys_of(with_key_moved(animation, amplitude, key, to))[key].seconds;
    };
    EXPECT_DOUBLE_EQ(moved(1, 0.73), 0.7);
    EXPECT_DOUBLE_EQ(moved(1, -5.0), 0.1);
    EXPECT_DOUBLE_EQ(moved(1, 5.0), 1.4);
    EXPECT_DOUBLE_EQ(moved(2, 5.0), 2.0);
    EXPECT_DOUBLE_EQ(moved(0, -1.0), 0.0);
}

TEST(KeyEdit, TheLastKeyLeavesItsValue) {
    Recipe recipe = load_recipe("marble");
    recipe.animation = animation_of({{0.0, 0.125}, {1.0, 0.75}});
    Recipe one = with_key_removed(recipe, amplitude, 0);
    EXPECT_EQ(keys_of(one.animation), (std::vector<KeyPoint>{{1.0, 0.75}}));
    one = with_key_removed(one, amplitude, 0);
    EXPECT_TRUE(one.animation.tracks.empty());
    EXPECT_EQ(plain_texture(one.texture)->noise[0].amplitude, 0.75);
    EXPECT_EQ(plain_texture(with_track_removed(recipe, amplitude, 0.5).texture)->noise[0].amplitude,
              0.4375);
}

TEST(KeyEdit, WhatIsSeenAtATimeIsWhatWasMadeOfIt) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    Recipe recipe = load_recipe("marble");
    recipe.animation = animation_of({{0.0, 0.1}, {2.0, 0.5}});
    for (int i = 0; i < 40; ++i) {
        const double time = nearest_frame(recipe.animation, 2.0 * unit(random));
        const std::string path = i % 3 == 0   ? "solid.scale"
                                 : i % 3 == 1 ? amplitude
                                              : "texture.stops.1.0";
        Recipe still = with_numbers(recipe_at(recipe, time),
                                    {fmt::format("{}={}", path, 0.39 + 0.2 * unit(random))});
        const Recipe edited = with_still(recipe, time, still);
        Recipe seen = recipe_at(edited, time);
        EXPECT_EQ(seen, still) << path << " at " << time;
        if (path != amplitude) {
            EXPECT_EQ(edited.animation, recipe.animation);
        }
        recipe = edited;
    }
    EXPECT_GT(recipe.animation.tracks[0].keys.size(), 5u);
}

TEST(KeyEdit, EditsOfUnkeyedNumbersCountAtAllTimes) {
    Recipe recipe = load_recipe("marble");
    recipe.animation = animation_of({{0.0, 0.1}, {2.0, 0.5}});
    const Recipe edited =
        with_still(recipe, 1.0, with_numbers(recipe_at(recipe, 1.0), {"solid.scale=2.5"}));
    for (const double time : {0.0, 0.7, 2.0}) {
        const Recipe seen = recipe_at(edited, time);
        EXPECT_EQ(seen.solid.scale, 2.5);
        EXPECT_EQ(plain_texture(seen.texture)->noise[0].amplitude,
                  value_at(recipe.animation.tracks[0], time));
    }
}

TEST(KeyEdit, KeysOfWhatIsGoneGoToo) {
    Recipe recipe = load_recipe("marble");
    recipe.animation = animation_of({{0.0, 0.1}});
    Recipe still = recipe_at(recipe, 0.0);
    plain_texture(still.texture)->noise.clear();
    EXPECT_TRUE(with_still(recipe, 0.0, still).animation.tracks.empty());
}

TEST(KeyEdit, WithoutKeysItIsTheRecipeItself) {
    const Recipe marble = load_recipe("marble"), wood = load_recipe("wood");
    EXPECT_EQ(with_still(marble, 1.0, wood), wood);
}

TEST(Clock, RunsToTheEndOrRoundAndRound) {
    KeyedAnimation animation{.seconds = 2.0, .rate = 10, .loop = false, .tracks = {}};
    EXPECT_EQ(clock_after(animation, 1.0, 0.5).seconds, 1.5);
    EXPECT_FALSE(clock_after(animation, 1.0, 0.5).ended);
    EXPECT_EQ(clock_after(animation, 1.9, 0.5).seconds, 2.0);
    EXPECT_TRUE(clock_after(animation, 1.9, 0.5).ended);
    animation.loop = true;
    EXPECT_NEAR(clock_after(animation, 1.9, 4.5).seconds, 0.4, 1e-12);
    EXPECT_FALSE(clock_after(animation, 1.9, 0.5).ended);
}

TEST(Clock, PlaysFromTheStartOnceItHasEndedAndStopsOnAFrame) {
    EditSession session(load_recipe("forming-marble"), "forming-marble");
    toggle_playing(session);
    advance(session, 0.51);
    EXPECT_DOUBLE_EQ(session.time(), 0.51);
    toggle_playing(session);
    EXPECT_DOUBLE_EQ(session.time(), 0.5);
    EXPECT_FALSE(session.timeline.moving());
    toggle_playing(session);
    advance(session, 9.0);
    EXPECT_EQ(session.time(), session.recipe().animation.seconds);
    EXPECT_FALSE(session.timeline.playing);
    toggle_playing(session);
    EXPECT_EQ(session.time(), 0.0);
    EXPECT_FALSE(session.history().can_undo());  // playing is no edit
}

TEST(KeyedSession, SlidersSetKeysOfKeyedNumbersAndUndoTakesThemBack) {
    EditSession session(load_recipe("forming-marble"), "forming-marble");
    const Recipe before = session.recipe();
    session.set_time(1.0);
    EXPECT_EQ(session.still(), recipe_at(before, 1.0));
    EXPECT_TRUE(session.set(amplitude, 0.375));
    EXPECT_EQ(plain_texture(session.still().texture)->noise[0].amplitude, 0.375);
    EXPECT_EQ(keys_of(session.recipe().animation)[1], (KeyPoint{1.0, 0.375}));
    EXPECT_TRUE(session.set("solid.scale", 3.0));
    EXPECT_EQ(session.recipe().animation.tracks[0].keys.size(), 3u);
    EXPECT_EQ(session.recipe().solid.scale, 3.0);
    session.history().undo();
    session.history().undo();
    EXPECT_EQ(session.recipe(), before);
    EXPECT_EQ(session.still(), recipe_at(before, 1.0));
}

}  // namespace
}  // namespace burl
