#include "procedural/graph/masks.h"

#include <algorithm>

#include <fmt/format.h>

namespace burl {

namespace {

/// The masks that a node reads, in their components' order.
std::vector<GraphMask> masks_of(const GraphNode& node) {
    const NodeMask& mask = type_of(node).mask;
    std::vector<GraphMask> masks;
    for (std::size_t c = 0; c < mask.components; ++c) {
        const auto begin = node.parameters.begin();
        masks.push_back({mask.kind, {begin, begin + std::ptrdiff_t(mask.numbers)}, c});
    }
    return masks;
}

/// Whether a node is a function that another program defines (point_function.h).
bool is_another_programs(const NodeType& type) {
    return type.name.starts_with("blender_") || type.name.starts_with("materialx_");
}

/// For each node whether the graph's output depends on it.
std::vector<bool> nodes_read(const TextureGraph& graph, GraphOutput output) {
    std::vector<bool> read(graph.nodes.size(), false);
    if (graph.empty()) return read;
    read[graph.result] = true;
    if (output == GraphOutput::planes)
        for (const GraphChannel& one : graph.channels) read[one.node] = true;
    for (std::size_t n = graph.nodes.size(); n-- > 1;) {
        if (!read[n]) continue;
        read[graph.nodes[n].place] = true;
        for (const std::uint32_t input : graph.nodes[n].inputs) read[input] = true;
    }
    return read;
}

}  // namespace

std::vector<GraphMask> graph_masks(const TextureGraph& graph) {
    std::vector<GraphMask> all;
    for (std::size_t n = 1; n < graph.nodes.size(); ++n)
        for (GraphMask& mask : masks_of(graph.nodes[n]))
            if (std::ranges::find(all, mask) == all.end()) all.push_back(std::move(mask));
    return all;
}

std::vector<bool> masks_read(const TextureGraph& graph, GraphOutput output) {
    const std::vector<GraphMask> all = graph_masks(graph);
    const std::vector<bool> nodes = nodes_read(graph, output);
    std::vector<bool> read(all.size(), false);
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
        if (!nodes[n]) continue;
        for (const GraphMask& mask : masks_of(graph.nodes[n]))
            read[std::size_t(std::ranges::find(all, mask) - all.begin())] = true;
    }
    return read;
}

std::string first_mask_node(const TextureGraph& graph, GraphOutput output) {
    const std::vector<bool> nodes = nodes_read(graph, output);
    for (std::size_t n = 1; n < graph.nodes.size(); ++n)
        if (nodes[n] && type_of(graph.nodes[n]).mask.components > 0)
            return std::string(type_of(graph.nodes[n]).name);
    return "";
}

std::string first_host_node(const TextureGraph& graph, GraphOutput output) {
    const std::vector<bool> nodes = nodes_read(graph, output);
    for (std::size_t n = 1; n < graph.nodes.size(); ++n)
        if (nodes[n] && is_another_programs(type_of(graph.nodes[n])))
            return std::string(type_of(graph.nodes[n]).name);
    return "";
}

bool has_slopes(const TextureGraph& graph, GraphOutput output) {
    const std::vector<bool> nodes = nodes_read(graph, output);
    for (std::size_t n = 1; n < graph.nodes.size(); ++n)
        if (nodes[n] && type_of(graph.nodes[n]).name == "slope") return true;
    return false;
}

std::string no_texels_for(const std::string& node) {
    if (node.empty()) return "";
    return fmt::format(
        "its node \"{}\" is worked out from the mesh at the texels of an atlas, of which there are "
        "none here",
        node);
}

}  // namespace burl
