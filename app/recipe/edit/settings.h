#pragma once
// Edits of recipe JSON by the command line's --set path=value.
#include <string>

#include "app/base/json_text.h"

namespace burl {

/// Applies "path=value" and returns the path. The value is JSON or, where that fails, a string.
/// Missing containers are created; an index one past an array's end appends. Throws Error(usage)
/// for a path that the parameter table does not have, naming the nearest one; the value is left to
/// find_problem.
std::string apply_setting(Json& recipe, const std::string& setting);

}  // namespace burl
