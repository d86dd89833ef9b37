#pragma once
// A recipe with keys over time is a recipe without them at every time.
#include "app/recipe/recipe.h"

namespace burl {

/// What the track's number is at a time: that of the first key before it, of the last one after it.
/// The track must have a key.
double value_at(const KeyTrack& track, double seconds);

/// The recipe of one time: its numbers are what their keys say, and keys it has none. A recipe
/// without keys comes back as it is. Throws Error(usage) where the numbers between two keys make no
/// recipe, such as stops that pass one another.
Recipe recipe_at(const Recipe& recipe, double seconds);

/// How many frames an animation has at its own rate: the last one is at its end or, of a loop, one
/// frame before it. At least 2.
int frame_count(const KeyedAnimation& animation);

/// When frame i of n (from 0, n at least 2) is: the first at 0, the last at the end; of a loop
/// frame n would be at the end.
double frame_seconds(const KeyedAnimation& animation, int i, int n);

}  // namespace burl
