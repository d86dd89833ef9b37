#pragma once
// Conversion of keys over time from and to a recipe's JSON (docs/reference/recipes.md,
// "Animation").
#include "app/base/json_text.h"
#include "app/recipe/key_track.h"

namespace burl {

/// The animation that the JSON describes; it must have passed find_animation_problem
/// (app/recipe/key_check.h).
KeyedAnimation animation_from_json(const Json& json);

/// JSON that animation_from_json reads back to an equal animation.
Json animation_to_json(const KeyedAnimation& animation);

}  // namespace burl
