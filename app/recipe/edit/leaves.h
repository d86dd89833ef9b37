#pragma once
// A recipe's parameters as a flat list, each with its entry in the parameter table; editors make
// sliders of them. Recipes of the 1999 model follow app/recipe/parameters.h, graphs the node table.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/json_text.h"
#include "app/recipe/recipe.h"
#include "atlas/base/json.h"
#include "procedural/batch/parameter.h"

namespace burl {

struct RecipeLeaf {
    std::string path;   ///< the dotted path, as --set takes it
    std::string group;  ///< the part of the recipe, such as "noise 1" or "wood_grain > fbm"
    std::string label;  ///< the parameter's key
    std::shared_ptr<const Parameter> parameter;
    Json value;  ///< the value; the default where the recipe's JSON has none
};

/// The recipe's JSON without paint strokes, which may be megabytes, and without keys: the part with
/// sliders.
Json slider_json(const Recipe& recipe);

/// All parameters in the order of the JSON and its tables, including constant inputs of nodes, but
/// no stops of colour maps, which have an editor of their own. A parameter without default that the
/// recipe leaves out is not listed.
std::vector<RecipeLeaf> recipe_leaves(const Json& recipe);

/// The paths of the recipe's colour maps: objects with a key "stops".
std::vector<std::string> color_map_paths(const Json& recipe);

}  // namespace burl
