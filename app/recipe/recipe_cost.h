#pragma once
// The cost of a recipe's textures, known before anything is run.
#include "app/recipe/recipe.h"

namespace burl {

/// The noises (procedural/graph/noise_count.h) that a point takes of all channels of the recipe's
/// material and, where `bumps`, of its height.
double noises_per_point(const Recipe& recipe, bool bumps);

/// The noises of a texel: those of noises_per_point() for every sample of the recipe's filter.
double noises_per_texel(const Recipe& recipe, bool bumps);

/// The noises of a square or oblong texture of the recipe's size.
double noises_of_texture(const Recipe& recipe, bool bumps);

}  // namespace burl
