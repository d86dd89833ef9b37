#include "app/recipe/edit/key_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/recipe/edit/key_check.h"
#include "app/recipe/edit/keyed_recipe.h"
#include "app/recipe/edit/leaves.h"
#include "app/recipe/edit/recipe_json.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

double half_frame(const KeyedAnimation& animation) {
    return 0.5 / double(animation.rate);
}

KeyTrack* track_of(KeyedAnimation& animation, std::string_view path) {
    const auto found = std::ranges::find(animation.tracks, path, &KeyTrack::path);
    return found == animation.tracks.end() ? nullptr : &*found;
}

Recipe with_number(const Recipe& recipe, const std::string& path, double value) {
    return with_numbers(recipe, {fmt::format("{}={}", path, value)});
}

}  // namespace

const KeyTrack* find_track(const KeyedAnimation& animation, std::string_view path) {
    const auto found = std::ranges::find(animation.tracks, path, &KeyTrack::path);
    return found == animation.tracks.end() ? nullptr : &*found;
}

double nearest_frame(const KeyedAnimation& animation, double seconds) {
    const double rate = animation.rate;
    return std::clamp(std::round(seconds * rate) / rate, 0.0, animation.seconds);
}

std::size_t key_near(const KeyedAnimation& animation, const KeyTrack& track, double seconds) {
    const auto near = [&](const KeyPoint& key) {
        return std::abs(key.seconds - seconds) < half_frame(animation);
    };
    return std::size_t(std::ranges::find_if(track.keys, near) - track.keys.begin());
}

KeyedAnimation with_key(KeyedAnimation animation, const std::string& path, double seconds,
                        double value) {
    if (!find_track(animation, path)) {
        KeyTrack track;
        track.path = path;
        animation.tracks.push_back(std::move(track));
    }
    KeyTrack& track = *track_of(animation, path);
    const std::size_t near = key_near(animation, track, seconds);
    if (near < track.keys.size()) {
        track.keys[near].value = value;
        return animation;
    }
    const auto next = std::ranges::upper_bound(track.keys, seconds, {}, &KeyPoint::seconds);
    track.keys.insert(next, {seconds, value});
    return animation;
}

KeyedAnimation with_key_moved(KeyedAnimation animation, std::string_view path, std::size_t key,
                              double seconds) {
    KeyTrack* track = track_of(animation, path);
    if (!track || key >= track->keys.size()) return animation;
    std::vector<KeyPoint>& keys = track->keys;
    const double frame = 1.0 / double(animation.rate);
    const double low = key == 0 ? 0.0 : keys[key - 1].seconds + frame;
    const double high = key + 1 == keys.size() ? animation.seconds : keys[key + 1].seconds - frame;
    if (low <= high) keys[key].seconds = std::clamp(nearest_frame(animation, seconds), low, high);
    return animation;
}

Recipe with_key_removed(Recipe recipe, const std::string& path, std::size_t key) {
    KeyTrack* track = track_of(recipe.animation, path);
    if (!track || key >= track->keys.size()) return recipe;
    if (track->keys.size() == 1) return with_track_removed(std::move(recipe), path, 0.0);
    track->keys.erase(track->keys.begin() + std::ptrdiff_t(key));
    return recipe;
}

Recipe with_track_removed(Recipe recipe, const std::string& path, double seconds) {
    const KeyTrack* keyed = find_track(recipe.animation, path);
    if (!keyed) return recipe;
    const double value = value_at(*keyed, seconds);
    std::erase_if(recipe.animation.tracks,
                  [&](const KeyTrack& track) { return track.path == path; });
    const auto number = find_number(slider_json(recipe), path);
    if (!number) return recipe;
    const bool whole = number->parameter->type == ParameterType::integer;
    return with_number(recipe, path, whole ? std::round(value) : value);
}

Recipe with_still(const Recipe& keyed, double seconds, Recipe still) {
    still.animation = keyed.animation;
    if (keyed.animation.tracks.empty()) return still;
    const Json before = slider_json(recipe_at(keyed, seconds)), now = slider_json(still);
    for (const KeyTrack& track : keyed.animation.tracks) {
        const std::string path = track.path;
        const auto was = find_number(before, path), is = find_number(now, path);
        if (!is)
            std::erase_if(still.animation.tracks,
                          [&](const KeyTrack& gone) { return gone.path == path; });
        else if (!was || is->value != was->value)
            still.animation = with_key(std::move(still.animation), path, seconds, is->value);
    }
    return still;
}

}  // namespace burl
