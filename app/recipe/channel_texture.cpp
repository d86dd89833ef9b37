#include "app/recipe/channel_texture.h"

#include <algorithm>
#include <utility>

#include "app/recipe/parameters.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "procedural/graph/json.h"
#include "procedural/graph/table.h"
#include "procedural/model/members.h"

namespace burl {

namespace {

using Json = nlohmann::ordered_json;

/// The material's numbers and colours by their names, without those that say how to use it.
Json constants_of(const Material& material) {
    Json json = Json::object();
    write_members(parameters(), material, json);
    json.erase("alpha");
    json.erase("alpha_cutoff");
    return json;
}

std::uint32_t push(TextureGraph& graph, std::string_view type, std::vector<std::uint32_t> inputs,
                   std::vector<double> parameters) {
    const auto index = std::uint32_t(find_node(type) - graph_table().data());
    graph.nodes.push_back(
        {index, Wire::number, 0, std::move(inputs), std::move(parameters), no_texture, no_texture});
    return std::uint32_t(graph.nodes.size() - 1);
}

/// The number of the node that gives a channel; none where it does not vary.
std::optional<std::uint32_t> node_of(const TextureGraph& graph, std::string_view name) {
    for (const auto& [channel, node] : graph.channels)
        if (to_string(channel) == name) return node;
    return {};
}

std::uint32_t push_alpha(TextureGraph& graph, const Recipe& recipe) {
    constexpr double alpha_choice = 3.0;
    const std::uint32_t alpha = push(graph, "split", {graph.result}, {alpha_choice});
    const std::uint32_t opacity =
        node_of(graph, "opacity").value_or(push(graph, "constant", {}, {recipe.material.opacity}));
    return push(graph, "multiply", {alpha, opacity}, {});
}

}  // namespace

std::vector<std::string> channel_names() {
    std::vector<std::string> names{"base_color", "alpha", "height"};
    const Json constants = constants_of({});
    for (const auto& [name, value] : constants.items()) names.push_back(name);
    return names;
}

TextureGraph channel_texture(const Recipe& recipe, const std::string& name) {
    TextureGraph graph = recipe.texture;
    if (name == "base_color") return graph;
    if (name == "height") {
        if (recipe.bump.empty())
            throw Error(ExitCode::usage, "the recipe has no height; add material.height to it");
        return recipe.bump.input;
    }
    if (name == "alpha")
        graph.result = push_alpha(graph, recipe);
    else if (const auto node = node_of(graph, name))
        graph.result = *node;
    else
        return graph_from_json(
            {{"node", "constant"}, {"value", constants_of(recipe.material)[name]}});
    graph.channels.clear();
    return graph;
}

}  // namespace burl
