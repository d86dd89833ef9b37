#pragma once
// Edits of recipe JSON by the command line's --set path=value.
#include <string>
#include <string_view>

#include "app/base/json_text.h"

namespace burl {

/// The text without the blanks round it.
std::string without_blanks(std::string_view text);

/// Throws Error(usage) for a setting that has no "=", or nothing before it.
void check_setting_form(const std::string& setting);

/// Applies "path=value" and returns the path. The value is JSON or, where that fails, a string.
/// Missing containers are created; an index one past an array's end appends. Throws Error(usage)
/// for a path that the parameter table does not have, naming the nearest one; the value is left to
/// find_problem.
std::string apply_setting(Json& recipe, const std::string& setting);

}  // namespace burl
