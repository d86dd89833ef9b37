#pragma once
// Edits of recipe JSON from the command line: --set path=value.
#include <string>

#include "app/base/json_text.h"

namespace burl {

/// Applies "path=value". The value is JSON, or else a string. Containers that are missing are made;
/// the index one past an array's end appends. Throws Error(usage) for a path the table does not
/// know, naming the nearest one; the value itself is left to find_problem. Returns the path.
std::string apply_setting(Json& recipe, const std::string& setting);

}  // namespace burl
