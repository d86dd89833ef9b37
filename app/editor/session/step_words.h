#pragma once
// What a step of the history did, told by the recipes before and after it.
#include <string>

#include "app/recipe/recipe.h"

namespace burl {

/// Tells in a few words how `before` became `after`: a control's or number's name with its new
/// value, "paint", "keys", or how many values changed.
std::string step_words(const Recipe& before, const Recipe& after);

}  // namespace burl
