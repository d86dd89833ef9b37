#include "procedural/graph/evaluator.h"

#include <algorithm>

#include "procedural/graph/table.h"
#include "procedural/model/band_limit.h"

namespace burl {

double NodeCall::parameter(std::string_view key, std::size_t component) const {
    std::size_t at = component;
    for (const Parameter& known : type_of(*node).parameters()) {
        if (known.path == key) return node->parameters[at];
        at += known.count;
    }
    return 0.0;
}

Vec3d NodeCall::vector(std::string_view key) const {
    return {parameter(key, 0), parameter(key, 1), parameter(key, 2)};
}

GraphEvaluator::GraphEvaluator(const TextureGraph& graph, const Filter& filter,
                               PrecisionKind precision)
    : graph_(graph), float32_(precision == PrecisionKind::float32) {
    for (const GraphNode& node : graph_.nodes) {
        first_channel_.push_back(channel_count_);
        channel_count_ += std::size_t(node.wire);
        PreparedNode& prepared = prepared_.emplace_back();
        if (node.texture == no_texture) continue;
        const Texture& texture = graph_.textures[node.texture];
        prepared.octaves = expand_octaves(texture);
        if (filter.band_limit)
            for (const Octave& octave : prepared.octaves)
                prepared.means.push_back(octave_mean(octave));
        else if (float32_)
            prepared.sums = lattice_sums(prepared.octaves);
        if (node.wire != Wire::color) continue;
        prepared.pieces.emplace_back(texture.colors);
        prepared.colors.emplace_back(texture.colors, filter.kind);
    }
}

std::span<Channel> GraphEvaluator::channels(Scratch& scratch, std::size_t node) const {
    return {scratch.data() + first_channel_[node], std::size_t(graph_.nodes[node].wire)};
}

void GraphEvaluator::evaluate_batch(std::span<const Footprint> footprints, Scratch& scratch) const {
    // Node 0 is the solid point.
    for (std::size_t n = 1; n < graph_.nodes.size(); ++n) {
        const GraphNode& node = graph_.nodes[n];
        NodeCall call;
        call.node = &node;
        call.graph = &graph_;
        call.prepared = &prepared_[n];
        call.float32 = float32_;
        for (std::size_t k = 0; k < node.inputs.size(); ++k)
            call.inputs[k] = channels(scratch, node.inputs[k]);
        call.place = channels(scratch, node.place);
        call.footprints = footprints;
        call.out = channels(scratch, n);
        type_of(node).evaluate(call);
    }
}

void GraphEvaluator::operator()(std::span<const Vec3d> points,
                                std::span<const Footprint> footprints, Scratch& scratch,
                                std::span<GraphSample> samples) const {
    static const std::array<Footprint, graph_batch_size> none{};
    const std::span<Channel> solid = channels(scratch, 0);
    const std::span<Channel> result = channels(scratch, graph_.nodes.size() - 1);
    for (std::size_t begin = 0; begin < points.size(); begin += graph_batch_size) {
        const std::size_t count = std::min(graph_batch_size, points.size() - begin);
        for (std::size_t i = 0; i < count; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                Vec3d slope(0.0);
                slope[axis] = 1.0;
                solid[std::size_t(axis)].set(i, {points[begin + i][axis], slope});
            }
        evaluate_batch(footprints.empty() ? std::span<const Footprint>(none).first(count)
                                          : footprints.subspan(begin, count),
                       scratch);
        for (std::size_t i = 0; i < count; ++i) {
            samples[begin + i].wire = graph_.nodes.back().wire;
            for (std::size_t c = 0; c < result.size(); ++c)
                samples[begin + i].channels[c] = result[c].get(i);
        }
    }
}

GraphSample GraphEvaluator::operator()(const Vec3d& point, const Footprint& footprint) const {
    Scratch scratch = make_scratch();
    GraphSample sample;
    (*this)({&point, 1}, {&footprint, 1}, scratch, {&sample, 1});
    return sample;
}

}  // namespace burl
