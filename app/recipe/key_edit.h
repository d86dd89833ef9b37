#pragma once
// Edits of keys over time, each from one recipe to the next: what a timeline's buttons and diamonds
// do, and where an edit of the recipe as it is shown at a time belongs.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// The track of a number; null: it has no keys.
const KeyTrack* find_track(const KeyedAnimation& animation, std::string_view path);

/// The frame's time that is nearest, from 0 to the end.
double nearest_frame(const KeyedAnimation& animation, double seconds);

/// The number's key whose frame that time lies in; the count of its keys: none.
std::size_t key_near(const KeyedAnimation& animation, const KeyTrack& track, double seconds);

/// The number has that value at that time: a new key, or the one that lies in the same frame.
KeyedAnimation with_key(KeyedAnimation animation, const std::string& path, double seconds,
                        double value);

/// The key lies as near to that time as the frames and the keys beside it let it; a key that is not
/// there changes nothing, here and below.
KeyedAnimation with_key_moved(KeyedAnimation animation, std::string_view path, std::size_t key,
                              double seconds);

/// Without the key; a number without keys is what its last one said.
Recipe with_key_removed(Recipe recipe, const std::string& path, std::size_t key);

/// The number has no keys any more and is what it is at that time.
Recipe with_track_removed(Recipe recipe, const std::string& path, double seconds);

/// A recipe whose state at that time is `still`, which is recipe_at(keyed, seconds) as somebody
/// edited it: changed numbers that are keyed get a key, all else changes at all times. Keys of
/// numbers that are there no more go with them.
Recipe with_still(const Recipe& keyed, double seconds, Recipe still);

}  // namespace burl
