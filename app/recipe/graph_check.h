#pragma once
// Checks the JSON of a texture graph against the table of nodes: names, inputs and what they give,
// parameters, depth and number of nodes.
#include "app/recipe/schema_check.h"

namespace burl {

/// The first thing that is wrong with a recipe's "texture" that is a graph, if any.
std::optional<RecipeProblem> find_graph_problem(const Json& texture, const std::string& path);

/// The same for a graph that must give a number; it may be a number itself.
std::optional<RecipeProblem> find_scalar_problem(const Json& input, const std::string& path);

}  // namespace burl
