#pragma once
// Edits of a recipe's JSON by all settings of a command line or a user interface, of paths and of
// controls.
#include <string>
#include <vector>

#include "app/base/json_text.h"

namespace burl {

/// Applies settings "path=value" and, after them, "control=value" to a recipe that has been checked
/// and respelled, then checks the result as a whole: single steps may pass through recipes that are
/// not valid (stops out of order). Throws Error(usage) that names the setting.
void apply_settings(Json& recipe, const std::vector<std::string>& settings);

/// The settings, after those of the arrays of which they set single numbers: arrays that the recipe
/// leaves out must be there first.
std::vector<std::string> with_arrays(const Json& recipe, const std::vector<std::string>& settings);

}  // namespace burl
