#pragma once
// Checks recipe JSON against the parameter table and, where the texture is a graph, against the
// node table. The conversion from JSON to a Recipe relies on the keys, types and ranges checked
// here.
#include "app/recipe/schema_check.h"

namespace burl {

/// The first problem of the recipe, if any.
std::optional<RecipeProblem> find_problem(const Json& recipe);

}  // namespace burl
