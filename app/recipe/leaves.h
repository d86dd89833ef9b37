#pragma once
// A recipe's parameters as a flat list, each with its entry in the parameter table: what sliders
// are made from. Recipes of the 1999 model follow app/recipe/parameters.h, graphs the table of
// nodes.
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/base/json_text.h"
#include "app/recipe/recipe.h"
#include "procedural/batch/parameter.h"

namespace burl {

struct RecipeLeaf {
    std::string path;   ///< dotted, as --set takes it
    std::string group;  ///< what it belongs to, such as "noise 1" or "wood_grain > fbm"
    std::string label;  ///< its key
    std::shared_ptr<const Parameter> parameter;
    Json value;  ///< as it is; the default where the recipe's JSON has none
};

/// The recipe's JSON without its strokes of paint, which may be megabytes, and without keys: what
/// has sliders.
Json slider_json(const Recipe& recipe);

/// In the order of the JSON and its tables, colour maps' stops left out (they have an editor of
/// their own); numbers and colours that stand in place of a node are listed, too. A parameter
/// without default that the recipe leaves out is not.
std::vector<RecipeLeaf> recipe_leaves(const Json& recipe);

/// The colour maps of a recipe: paths of the nodes that have "stops".
std::vector<std::string> color_map_paths(const Json& recipe);

}  // namespace burl
