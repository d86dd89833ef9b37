#include "app/recipe/check.h"

#include <nlohmann/json.hpp>

#include "app/recipe/graph_check.h"
#include "app/recipe/key_check.h"
#include "app/recipe/model_check.h"
#include "app/recipe/precision_check.h"
#include "procedural/graph/json.h"

namespace burl {

namespace {

using Found = std::optional<RecipeProblem>;

/// The schema whose texture is left to find_graph_problem.
SchemaNode schema_without_texture() {
    SchemaNode schema = build_schema();
    for (auto& [name, node] : schema.children)
        if (name == "texture") node->elsewhere = true;
    return schema;
}

/// The first problem of "bump.input", in a recipe that has passed the schema.
Found find_bump_problem(const Json& recipe) {
    if (!recipe.contains("bump")) return {};
    if (!recipe["bump"].contains("input"))
        return RecipeProblem{"bump.input",
                             "bump.input is missing, must be a node that gives a number"};
    return find_scalar_problem(recipe["bump"]["input"], "bump.input");
}

Found find_texture_problem(const Json& recipe) {
    const Json none = Json::object();
    const Json& texture =
        recipe.is_object() && recipe.contains("texture") ? recipe["texture"] : none;
    if (is_graph(texture)) {
        if (Found found = check_value(schema_without_texture(), recipe, "")) return found;
        if (Found found = find_graph_problem(texture, "texture")) return found;
        return find_precision_problem(recipe);
    }
    if (Found found = check_value(recipe_schema(), recipe, "")) return found;
    if (Found found = find_map_problem(texture, "texture")) return found;
    if (texture.contains("input"))
        if (Found found = find_field_problem(texture["input"], "texture.input")) return found;
    return find_precision_problem(recipe);
}

}  // namespace

Found find_problem(const Json& recipe) {
    if (Found found = find_texture_problem(recipe)) return found;
    if (Found found = find_bump_problem(recipe)) return found;
    return find_animation_problem(recipe);
}

}  // namespace burl
