#pragma once
// The one table of a recipe's parameters. It says which keys the JSON knows, what values they take
// and what they mean; `burl list parameters`, --set, range checks and docs/reference/recipes.md
// follow it.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "procedural/batch/parameter.h"

namespace burl {

/// In the order of the JSON.
std::span<const Parameter> parameters();

/// "number", "integer", ... as the documentation calls it.
std::string_view to_string(ParameterType type);

/// Words of a list separated by "|".
std::vector<std::string_view> split_choices(std::string_view choices);

/// The candidate with the smallest edit distance to `word`; empty when there is none that shares
/// more than it lacks.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace burl
