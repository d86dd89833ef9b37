#include "procedural/graph/planes.h"

#include <algorithm>

#include "procedural/graph/table.h"

namespace burl {

std::vector<Register> plane_registers(const GraphProgram& program) {
    std::vector<Register> planes = program.results;
    if (planes.size() == 1) planes.assign(3, program.results.front());
    for (const std::vector<Register>& channel : program.channels)
        planes.insert(planes.end(), channel.begin(), channel.end());
    return planes;
}

PlaneLayout::PlaneLayout(const TextureGraph& graph) {
    if (graph.nodes[graph.result].wire == Wire::color) alpha_ = count_++;
    for (const auto& [channel, node] : graph.channels) {
        first_[std::size_t(channel)] = count_;
        count_ += is_color(channel) ? 3 : 1;
    }
}

bool is_opaque(const TextureGraph& graph, std::uint32_t node) {
    const GraphNode& self = graph.nodes[node];
    if (self.wire != Wire::color) return true;
    const NodeType& type = type_of(self);
    if (type.name == "constant") return self.parameters[3] >= 255.0;
    if (type.name == "vertex_color") return NodeParameters(self).parameter("alpha") == 0.0;
    if (type.name == "lighting") return true;
    // A layer over an opaque base is opaque together with it.
    if (type.name == "layer_over" || type.name == "blend") return is_opaque(graph, self.inputs[1]);
    if (type.name == "image") return !graph.images[self.image].pixels->alpha();
    if (type.name == "color_map") return is_opaque(graph.textures[self.texture].colors);
    return std::ranges::all_of(self.inputs,
                               [&](std::uint32_t input) { return is_opaque(graph, input); });
}

}  // namespace burl
