#pragma once
// Controls: what a recipe's "controls" (control.h) are at present, what is wrong with them, and
// what a value of one sets. All functions work on recipe JSON in the one spelling (spelling.h).
#include <optional>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/control.h"
#include "app/recipe/edit/places.h"
#include "app/recipe/schema_check.h"
#include "atlas/base/json.h"

namespace burl {

/// An entry of a control's "sets".
struct ControlTarget {
    std::string path;
    std::string formula;  ///< of the control's value; empty: the value itself
};

/// The two parts of an entry, around its first "=".
ControlTarget control_target(const std::string& entry);

/// A control with the value that the recipe has where it first sets.
struct ControlState {
    RecipeControl control;
    std::string path;    ///< the path of its value
    Json value;          ///< a number, or a colour "#rrggbb"
    bool whole = false;  ///< whether the number is rounded
};

/// The controls of a recipe that has been checked, in its order.
std::vector<ControlState> control_states(const Json& recipe);

/// The first problem of "controls"; the rest of the recipe must have been checked.
std::optional<RecipeProblem> find_control_problem(const Json& recipe);

/// Whether a setting "NAME=VALUE" begins with the name of one of the recipe's controls, in any
/// case.
bool sets_control(const Json& recipe, const std::string& setting);

/// The name of the control that a setting of something unknown may have meant; empty: none.
std::string nearest_control(const Json& recipe, const std::string& setting);

/// A number or colour that a setting changes.
struct ControlEdit {
    std::string said;  ///< the setting, of a control or of a path
    std::string path, value;
    bool own = true;  ///< whether it is the control's own value, rather than one that follows it

    std::string setting() const { return path + "=" + value; }
};

/// All that settings "NAME=VALUE" of controls change. What follows a control's value yields to what
/// another setting, or one of the `plain` ones, sets by itself. Throws Error(usage) for a value out
/// of the control's range, for two settings of one place, and for a place that the recipe has keys
/// of.
std::vector<ControlEdit> control_edits(const Json& recipe, const std::vector<std::string>& settings,
                                       const std::vector<ControlEdit>& plain);

}  // namespace burl
