#pragma once
// Names for nodes, as people call them: by what they are and where they are used, such as "rings
// (fract)", "fbm in rings", "mix 2 in base colour".
#include <map>
#include <string>
#include <string_view>

#include "app/base/json_text.h"

namespace burl {

/// The names of all nodes and noise terms of a recipe's JSON by their places.
using NodeWords = std::map<std::string, std::string>;
NodeWords node_words(const Json& recipe);

/// The name of a part that has nodes: "base colour" for "texture", "height" for "bump.input",
/// "clearcoat roughness" for "material.clearcoat_roughness", "rings" for "define.rings"; for what
/// lies below one, its.
std::string part_words(std::string_view place);

/// The name of a place: that of its part, or "amount of mix" for an input.
std::string place_words(const Json& recipe, const std::string& place);

}  // namespace burl
