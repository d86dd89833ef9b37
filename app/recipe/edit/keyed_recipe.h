#pragma once
// Evaluation of a keyed recipe: at every time it is a recipe without keys.
#include "app/recipe/recipe.h"

namespace burl {

/// The value of the track's number at a time: interpolated between keys, constant before the first
/// and after the last. The track has at least one key.
double value_at(const KeyTrack& track, double seconds);

/// The recipe at a time: its numbers have their keyed values, and it has no keys. A recipe without
/// keys is returned unchanged. Throws Error(usage) where the values make no valid recipe, such as
/// stops out of order.
Recipe recipe_at(const Recipe& recipe, double seconds);

/// The number of frames at the animation's own rate, at least 2. The last frame is at the end or,
/// for a loop, one frame before it.
int frame_count(const KeyedAnimation& animation);

/// The time of frame i of n (i from 0, n at least 2), in seconds: the first at 0, the last at the
/// end. For a loop, frame n would be at the end.
double frame_seconds(const KeyedAnimation& animation, int i, int n);

}  // namespace burl
