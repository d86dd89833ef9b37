#pragma once
// One channel of a recipe's material as a texture of its own.
#include <string>
#include <vector>

#include "app/recipe/recipe.h"

namespace burl {

/// The names that channel_texture takes: "base_color", "alpha" (the base colour's alpha times the
/// opacity), "height" and the material's numbers, colours and channels.
std::vector<std::string> channel_names();

/// The graph that gives the channel of that name, which must be one of channel_names(). Throws
/// Error(usage) for the height of a recipe without one.
TextureGraph channel_texture(const Recipe& recipe, const std::string& name);

}  // namespace burl
