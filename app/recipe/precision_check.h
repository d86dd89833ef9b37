#pragma once
// Recipes that fixed point cannot evaluate are refused with one sentence, rather than baked as
// another texture.
#include "app/recipe/schema_check.h"

namespace burl {

/// The problem of a recipe with precision.kind "fixed" that asks for noise, nodes or filters
/// without a fixed-point form. Keys, types and ranges must have been checked.
std::optional<RecipeProblem> find_precision_problem(const Json& recipe);

}  // namespace burl
