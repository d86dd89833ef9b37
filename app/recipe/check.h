#pragma once
// Checks recipe JSON against the parameter table and, where the texture is a graph, the table of
// nodes. What turns JSON into a Recipe afterwards may rely on keys, types and ranges.
#include "app/recipe/schema_check.h"

namespace burl {

/// The first thing that is wrong with the recipe, if any.
std::optional<RecipeProblem> find_problem(const Json& recipe);

}  // namespace burl
