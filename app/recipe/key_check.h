#pragma once
// Which numbers of a recipe may be keyed over time, and what may be wrong with its keys.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/schema_check.h"

namespace burl {

/// One number of a recipe, as it is without keys.
struct RecipeNumber {
    std::string path;                            ///< as --set takes it
    std::shared_ptr<const Parameter> parameter;  ///< whose range it has
    double value = 0.0;
};

/// All that have a slider of their own, and the stops of colour maps; nothing of the atlas, which
/// all frames share. The recipe's texture must have been checked.
std::vector<RecipeNumber> recipe_numbers(const Json& recipe);

/// One of them.
std::optional<RecipeNumber> find_number(const Json& recipe, std::string_view path);

/// The first thing that is wrong with the recipe's "animation", all else having been checked.
std::optional<RecipeProblem> find_animation_problem(const Json& recipe);

}  // namespace burl
