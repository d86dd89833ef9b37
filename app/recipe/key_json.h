#pragma once
// Keys over time as a recipe's JSON has them (docs/reference/recipes.md, "Animation").
#include "app/base/json_text.h"
#include "app/recipe/key_track.h"

namespace burl {

/// `json` must have passed find_animation_problem (app/recipe/key_check.h).
KeyedAnimation animation_from_json(const Json& json);

/// JSON that animation_from_json reads back to an equal animation.
Json animation_to_json(const KeyedAnimation& animation);

}  // namespace burl
