#pragma once
// Edits of keys over time, each from one recipe to the next: those of a timeline's buttons and
// diamonds, and edits of the recipe shown at one time.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// The track of the number at the path; null where it has no keys.
const KeyTrack* find_track(const KeyedAnimation& animation, std::string_view path);

/// The time of the nearest frame, from 0 to the animation's end, in seconds.
double nearest_frame(const KeyedAnimation& animation, double seconds);

/// The index of the track's key less than half a frame away from the time; the number of keys where
/// there is none.
std::size_t key_near(const KeyedAnimation& animation, const KeyTrack& track, double seconds);

/// The animation in which the number has the value at the time: in the key of the same frame where
/// there is one, else in a new key.
KeyedAnimation with_key(KeyedAnimation animation, const std::string& path, double seconds,
                        double value);

/// The animation with the key moved to the frame nearest to the time, at least one frame apart from
/// the keys beside it; unchanged where there is no such key or no room.
KeyedAnimation with_key_moved(KeyedAnimation animation, std::string_view path, std::size_t key,
                              double seconds);

/// The recipe without the key, unchanged where there is no such key. Removing a number's last key
/// leaves the key's value as the number's own.
Recipe with_key_removed(Recipe recipe, const std::string& path, std::size_t key);

/// The recipe in which the number has no keys and keeps the value that they give at the time.
Recipe with_track_removed(Recipe recipe, const std::string& path, double seconds);

/// The keyed recipe whose state at the time is `still`, an edited copy of recipe_at(keyed,
/// seconds). Changed numbers that are keyed get a key; all other changes hold at all times. Tracks
/// of numbers that no longer exist are removed.
Recipe with_still(const Recipe& keyed, double seconds, Recipe still);

}  // namespace burl
