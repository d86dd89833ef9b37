#pragma once
// All numbers and colours of a recipe that --set can change, as a flat list: those with sliders
// (leaves.h), stops of colour maps and constants of graphs.
#include <memory>
#include <string>
#include <vector>

#include "app/base/json_text.h"
#include "atlas/base/json.h"
#include "procedural/batch/parameter.h"

namespace burl {

struct RecipePlace {
    std::string path;  ///< the dotted path, as --set takes it
    Json value;        ///< a number, or a colour "#rrggbb"
    /// The entry of a table whose range a number has; null for colours and for what has no entry.
    std::shared_ptr<const Parameter> parameter{};

    bool is_color() const { return value.is_string(); }
};

/// Whether the value is a string that can only be a colour.
bool is_color_text(const Json& value);

/// The places of a recipe that has been checked; defaults that it leaves out are among them, paint,
/// keys and controls are not.
std::vector<RecipePlace> recipe_places(const Json& recipe);

/// The place at a path, or null. "material.base_color" and "material.height" are other words for
/// "texture" and "bump.input", and a constant node is at its own path what it is at its "value".
const RecipePlace* find_place(const std::vector<RecipePlace>& places, const std::string& path);

}  // namespace burl
