#pragma once
// Checks the two nodes of the 1999 model, colour map and field, wherever in a texture they stand.
#include "app/recipe/schema_check.h"

namespace burl {

/// A color_map's `wrap` and `stops`; `schema` is build_schema()'s.
std::optional<RecipeProblem> find_map_problem(const SchemaNode& schema, const Json& map,
                                              const std::string& path);

/// Why noise of a kind cannot have a time, as the end of a sentence; empty if it can. `repeats`: it
/// has a period along any axis or time.
std::string time_problem(std::string_view kind, bool repeats);

/// A field as a whole.
std::optional<RecipeProblem> find_field_problem(const SchemaNode& schema, const Json& field,
                                                const std::string& path);

}  // namespace burl
