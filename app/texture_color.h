#pragma once
// The recipe's texture as a function, in float64 and unfiltered: what pictures and measures hold
// bakes against.
#include <functional>

#include "app/recipe.h"

namespace burl {

/// Linear-light colour at texture coordinates s. May be called from several threads at once.
using TextureColor = std::function<Vec3d(const Vec3d& s)>;

TextureColor texture_color(const Recipe& recipe);

}  // namespace burl
