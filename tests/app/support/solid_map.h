#pragma once
// The map of a recipe's solid transform, for tests of the tools that change it.
#include "app/recipe/recipe.h"

namespace burl {

inline Affine3 map_of(const SolidOptions& solid) {
    Recipe recipe;
    recipe.solid = solid;
    return texture_from_solid(recipe);
}

}  // namespace burl
