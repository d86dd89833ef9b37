#pragma once
// Recipes that the kernel `forward` cannot bake are refused with one sentence, rather than baked as
// another texture.
#include "app/recipe/recipe.h"

namespace burl {

/// Throws Error(usage) where the recipe's texture is not a polynomial between cell crossings
/// (procedural/bresenham), has a filter, or asks for fixed-point arithmetic.
void check_forward(const Recipe& recipe);

}  // namespace burl
