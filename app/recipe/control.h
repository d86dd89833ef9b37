#pragma once
// Controls, the few numbers and colours of a recipe that a person is meant to change, as data of
// the recipe. Each has a name and sets any number of the recipe's parameters
// (app/recipe/edit/controls.h).
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace burl {

struct RecipeControl {
    std::string name{};   ///< what people call it, unlike any path of a recipe
    std::string about{};  ///< a description in a few words
    /// The least and the greatest value of a number; none: the control is a colour.
    std::optional<std::array<double, 2>> range{};
    /// The paths that it sets. The value at the first, a path alone, is the control's own; others
    /// may be "path = formula", with a formula of x, the control's value (formula.h).
    std::vector<std::string> sets{};
    bool operator==(const RecipeControl&) const = default;
};

}  // namespace burl
