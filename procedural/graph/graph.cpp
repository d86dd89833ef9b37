#include "procedural/graph/graph.h"

#include <utility>

#include "procedural/graph/table.h"

namespace burl {

namespace {

/// The nodes of every plain graph.
std::vector<GraphNode> make_plain_nodes() {
    const auto type = [](std::string_view name) {
        return std::uint32_t(find_node(name) - graph_table().data());
    };
    GraphNode solid, field, color_map;
    solid.wire = Wire::point;
    field.type = type("field");
    color_map.type = type("color_map");
    color_map.wire = Wire::color;
    color_map.inputs = {1};
    field.texture = color_map.texture = 0;
    return {solid, field, color_map};
}

const std::vector<GraphNode>& plain_nodes() {
    static const std::vector<GraphNode> nodes = make_plain_nodes();
    return nodes;
}

}  // namespace

TextureGraph plain_graph(Texture texture) {
    TextureGraph graph;
    graph.nodes = plain_nodes();
    graph.textures = {std::move(texture)};
    graph.result = std::uint32_t(graph.nodes.size() - 1);
    return graph;
}

const Texture* plain_texture(const TextureGraph& graph) {
    const bool plain = graph.nodes == plain_nodes() && graph.channels.empty() &&
                       is_opaque(graph.textures.front().colors);
    return plain ? &graph.textures.front() : nullptr;
}

Texture* plain_texture(TextureGraph& graph) {
    return const_cast<Texture*>(plain_texture(std::as_const(graph)));
}

}  // namespace burl
