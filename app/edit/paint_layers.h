#pragma once
// The layers of paint that a recipe has as masks: numbers that its nodes `paint` read, or in which
// there are strokes.
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// The layers, ascending, without 0, the colour over the texture.
std::vector<int> paint_layers(const Recipe& recipe);

/// The least layer that the recipe does not have; the largest one where it has them all.
int free_paint_layer(const Recipe& recipe);

}  // namespace burl
