#pragma once
// What the kernel `forward` cannot bake: one sentence instead of a texture that is something else.
#include "app/recipe/recipe.h"

namespace burl {

/// Throws Error(usage) if the recipe's texture is no polynomial between cell crossings, or is asked
/// for with a filter or in another arithmetic than the kernel has.
void check_forward(const Recipe& recipe);

}  // namespace burl
