#include "app/recipe/edit/keyed_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/recipe/edit/key_check.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/error.h"

namespace burl {

namespace {

bool is_whole(const std::vector<RecipeNumber>& numbers, const std::string& path) {
    const auto found = std::ranges::find(numbers, path, &RecipeNumber::path);
    return found != numbers.end() && found->parameter->type == ParameterType::integer;
}

/// The error of with_numbers() with the time in its sentence instead of "--set".
Error with_time(const Error& error, double seconds) {
    std::string sentence = error.what();
    for (const std::string_view set : {"--set: ", "--set "})
        if (sentence.starts_with(set)) sentence.erase(0, set.size());
    return Error(error.code(), fmt::format("keys at {} s: {}", seconds, sentence));
}

}  // namespace

double value_at(const KeyTrack& track, double seconds) {
    const auto next = std::ranges::upper_bound(track.keys, seconds, {}, &KeyPoint::seconds);
    if (next == track.keys.begin()) return next->value;
    const KeyPoint& before = *std::prev(next);
    if (next == track.keys.end()) return before.value;
    const double x = (seconds - before.seconds) / (next->seconds - before.seconds);
    const double share = track.ease == KeyEase::smooth ? x * x * (3.0 - 2.0 * x) : x;
    return (1.0 - share) * before.value + share * next->value;
}

Recipe recipe_at(const Recipe& recipe, double seconds) {
    if (recipe.animation.tracks.empty()) return recipe;
    const std::vector<RecipeNumber> numbers = recipe_numbers(slider_json(recipe));
    std::vector<std::string> settings;
    for (const KeyTrack& track : recipe.animation.tracks) {
        const double value = value_at(track, seconds);
        settings.push_back(fmt::format("{}={}", track.path,
                                       is_whole(numbers, track.path) ? std::round(value) : value));
    }
    try {
        Recipe still = with_numbers(recipe, settings);
        still.animation = {};
        return still;
    } catch (const Error& error) {
        throw with_time(error, seconds);
    }
}

int frame_count(const KeyedAnimation& animation) {
    const int steps = int(std::lround(animation.seconds * animation.rate));
    return std::max(2, animation.loop ? steps : steps + 1);
}

double frame_seconds(const KeyedAnimation& animation, int i, int n) {
    return animation.seconds * double(i) / double(animation.loop ? n : n - 1);
}

}  // namespace burl
