#include "procedural/graph/program.h"

#include "procedural/graph/node_ops.h"
#include "procedural/noise/noise.h"

namespace burl {

double OctaveSum::mean() const {
    const bool timed = noise.time.has_value();
    return shape == OctaveShape::absolute ? mean_absolute(noise.kind, timed)
                                          : mean_value(noise.kind, timed);
}

NoiseSum OctaveSum::sum(double factor) const {
    NoiseSum result{noise, shape, {}, 0.0};
    double weight = 1.0, frequency = 1.0;
    for (double k = 0.0; k < octaves && weight != 0.0; ++k) {
        result.octaves.push_back({noise.seed + std::uint32_t(k), factor * frequency, weight});
        weight *= gain;
        frequency *= lacunarity;
    }
    result.noise.seed = 0;
    return result;
}

namespace {

/// The first `count` of a node's registers; a number is a grey.
std::vector<Register> channel_registers(const std::vector<Register>& node, std::size_t count) {
    if (node.size() < count) return std::vector<Register>(count, node.front());
    return {node.begin(), node.begin() + std::ptrdiff_t(count)};
}

}  // namespace

GraphProgram program_of(const TextureGraph& graph) {
    GraphProgram program;
    std::vector<std::vector<Register>> channels{{0, 1, 2}};  // those of the solid point
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
        NodeOps node(graph, n, channels, program);
        channels.push_back(type_of(graph.nodes[n]).define(node));
    }
    program.results = channels[graph.result];
    for (const GraphChannel& one : graph.channels)
        program.channels.push_back(
            channel_registers(channels[one.node], is_color(one.channel) ? 3 : 1));
    return program;
}

}  // namespace burl
