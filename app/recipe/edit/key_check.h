#pragma once
// The numbers of a recipe that can be keyed over time, and the checks of their keys.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/schema_check.h"

namespace burl {

/// A number of a recipe, with its value apart from keys.
struct RecipeNumber {
    std::string path;                            ///< the dotted path, as --set takes it
    std::shared_ptr<const Parameter> parameter;  ///< the entry whose range the number has
    double value = 0.0;
};

/// All numbers that have a slider, and the positions of colour maps' stops; none of the atlas,
/// which all frames share. The recipe's texture must have been checked.
std::vector<RecipeNumber> recipe_numbers(const Json& recipe);

/// The number at the path, of those that recipe_numbers() gives; no value where it is none of them.
std::optional<RecipeNumber> find_number(const Json& recipe, std::string_view path);

/// The first problem of the recipe's "animation"; the rest of the recipe must have been checked.
std::optional<RecipeProblem> find_animation_problem(const Json& recipe);

}  // namespace burl
