#pragma once
// Checks the JSON of a texture graph against the node table: node names, inputs and their types,
// parameters, depth and number of nodes. The two nodes of the 1999 texture, colour map and field,
// follow the recipe's table wherever they stand.
#include "app/recipe/schema_check.h"

namespace burl {

/// The first problem of a color_map's `wrap` and `stops`.
std::optional<RecipeProblem> find_map_problem(const Json& map, const std::string& path);

/// The first problem of a field: keys, values, periods and times.
std::optional<RecipeProblem> find_field_problem(const Json& field, const std::string& path);

/// The first problem of what a recipe's graph is made of: a "texture" that is a graph, the channels
/// of "material" that are nodes, and all of "define", whose names must not lead back to themselves.
std::optional<RecipeProblem> find_material_problem(const Json& texture, const Json& material,
                                                   const Json& define);

/// The first problem of a graph that must give a number, or of a plain number in its place; its
/// names are those of `define`.
std::optional<RecipeProblem> find_scalar_problem(const Json& input, const std::string& path,
                                                 const Json& define);

}  // namespace burl
