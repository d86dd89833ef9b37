#pragma once
// What fixed point cannot do: one sentence instead of a texture that is something else.
#include "app/recipe/schema_check.h"

namespace burl {

/// Whether a recipe with precision.kind "fixed" asks for noises, nodes or filters without fixed
/// point. Keys, types and ranges must have been checked.
std::optional<RecipeProblem> find_precision_problem(const Json& recipe);

}  // namespace burl
