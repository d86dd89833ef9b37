#include "app/recipe/edit/check.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/recipe/edit/controls.h"
#include "app/recipe/edit/key_check.h"
#include "app/recipe/graph_check.h"
#include "app/recipe/schema_check.h"
#include "app/recipe/spelling.h"
#include "atlas/base/json.h"
#include "procedural/graph/json.h"
#include "procedural/model/texture_json.h"

namespace burl {

namespace {

using Found = std::optional<RecipeProblem>;

// Recipes that fixed point cannot evaluate are refused with one sentence, rather than baked as
// another texture.

/// The feature of a noise term that has no fixed-point form; empty where all have one.
std::string noise_problem(const Json& term) {
    const std::string kind = term.value("kind", "value");
    if (kind != "value" && kind != "perlin") return kind + " noise";
    if (term.contains("time")) return "noise in time";
    const Json period = term.value("period", Json::array());
    const bool repeats = std::any_of(period.begin(), period.end(),
                                     [](const Json& cells) { return cells.get<double>() != 0.0; });
    return repeats ? "noise with a period" : "";
}

bool has_transparent_stop(const Json& map) {
    const Json stops = map.value("stops", Json::array());
    return std::ranges::any_of(
        stops, [](const Json& stop) { return alpha_from_hex(stop[1].get<std::string>()) < 255; });
}

std::string texture_problem(const Json& texture) {
    if (is_graph(texture))
        return "the texture has other nodes than a color_map over a field; use float64";
    if (has_transparent_stop(texture))
        return "a stop of texture.stops is transparent; use float64, or leave its alpha out";
    const Json none = Json::object();
    const Json& field = texture.contains("input") ? texture["input"] : none;
    if (!field.contains("noise")) return "";
    for (std::size_t i = 0; i < field["noise"].size(); ++i)
        if (const std::string problem = noise_problem(field["noise"][i]); !problem.empty())
            return fmt::format(
                "texture.input.noise.{} is {}; fixed point has value and perlin noise without "
                "period and time",
                i, problem);
    return "";
}

std::string filter_problem(const Json& filter) {
    if (filter.value("octaves", "keep") == "fade")
        return "filter.octaves is \"fade\"; fixed point keeps all octaves";
    return "";
}

/// The problem of a recipe with precision.kind "fixed" that asks for noise, nodes or octaves
/// without a fixed-point form. Keys, types and ranges must have been checked.
Found find_precision_problem(const Json& recipe) {
    const auto part = [&](const char* key) -> const Json& { return part_of(recipe, key); };
    if (part("precision").value("kind", "") != "fixed") return {};
    std::string problem = texture_problem(part("texture"));
    if (problem.empty() && without_channel_nodes(part("material")) != part("material"))
        problem = "channels of the material are nodes; use float64";
    if (problem.empty()) problem = filter_problem(part("filter"));
    if (problem.empty()) return {};
    return RecipeProblem{"precision.kind",
                         fmt::format("precision.kind is \"fixed\", but {}", problem)};
}

/// The recipe without what is left to find_material_problem: "define", channels that are nodes,
/// and a texture that is a graph.
Json without_graphs(const Json& recipe) {
    Json rest = recipe;
    if (!rest.is_object()) return rest;
    rest.erase("define");
    if (rest.contains("texture") && is_graph(rest["texture"])) rest.erase("texture");
    if (!rest.contains("material") || !rest["material"].is_object()) return rest;
    rest["material"] = without_channel_nodes(rest["material"]);
    return rest;
}

/// The first problem of "bump.input", in a recipe that has passed the schema.
Found find_bump_problem(const Json& recipe) {
    if (!recipe.contains("bump")) return {};
    if (!recipe["bump"].contains("input"))
        return RecipeProblem{"bump.input",
                             "bump.input is missing, must be a node that gives a number"};
    return find_scalar_problem(recipe["bump"]["input"], "bump.input", part_of(recipe, "define"));
}

/// The first problem of a texture that is a colour map over a field.
Found find_plain_problem(const Json& texture) {
    if (Found found = find_map_problem(texture, "texture")) return found;
    if (!texture.contains("input")) return {};
    return find_field_problem(texture["input"], "texture.input");
}

Found find_texture_problem(const Json& recipe) {
    if (Found found = check_value(recipe_schema(), without_graphs(recipe), "")) return found;
    const Json& texture = part_of(recipe, "texture");
    if (!is_graph(texture))
        if (Found found = find_plain_problem(texture)) return found;
    return find_material_problem(texture, part_of(recipe, "material"), part_of(recipe, "define"));
}

Found find_respelled_problem(const Json& recipe) {
    if (Found found = find_texture_problem(recipe)) return found;
    if (Found found = find_precision_problem(recipe)) return found;
    if (Found found = find_bump_problem(recipe)) return found;
    if (Found found = find_animation_problem(recipe)) return found;
    return find_control_problem(recipe);
}

}  // namespace

Found find_problem(const Json& recipe) {
    if (Found found = find_spelling_problem(recipe)) return found;
    Found found = find_respelled_problem(respelled(recipe));
    if (found) found = as_written(*found, recipe);
    return found;
}

}  // namespace burl
