#pragma once
// Checks the two nodes of the 1999 model, colour map and field, wherever they stand in a texture.
#include "app/recipe/schema_check.h"

namespace burl {

/// The first problem of a color_map's `wrap` and `stops`.
std::optional<RecipeProblem> find_map_problem(const Json& map, const std::string& path);

/// The reason why a kind of noise cannot have a time, as the end of a sentence; empty where it can.
/// `repeats` tells that the noise has a period along an axis or in time.
std::string time_problem(std::string_view kind, bool repeats);

/// The first problem of a field: keys, values, periods and times.
std::optional<RecipeProblem> find_field_problem(const Json& field, const std::string& path);

}  // namespace burl
