#include "procedural/graph/noise_count.h"

#include <algorithm>

#include "procedural/graph/values.h"

namespace burl {

namespace {

/// The octaves of a noise whose point decides how many there are.
constexpr std::size_t most_octaves = 16;

std::size_t noises_of(const auto&) {
    return 0;
}
std::size_t noises_of(const NoiseSum& sum) {
    return sum.octaves.size();
}
std::size_t noises_of(const SimplexOctaves& sum) {
    return 4 * std::size_t(sum.octaves.octaves);
}
std::size_t noises_of(const CurlOctaves& field) {
    return 3 * std::size_t(field.octaves.octaves);
}
std::size_t noises_of(const CellFeature&) {
    return 1;
}
std::size_t noises_of(const ScatteredShapes&) {
    return 4;
}
std::size_t noises_of(const GraphSlope& slope) {
    return graph_noises(slope.graph->graph(), GraphOutput::color);
}
std::size_t noises_of(const BlenderCall& call) {
    using enum BlenderFunction;
    if (call.function == noise || call.function == musgrave || call.function == wave)
        return most_octaves;
    return call.function == voronoi || call.function == white_noise ? 1 : 0;
}
std::size_t noises_of(const MaterialXCall& call) {
    using enum MaterialXFunction;
    if (call.function == math || call.function == vector_math) return 0;
    return std::size_t(call.results) * (call.function == fractal ? most_octaves : 1);
}
std::size_t noises_of(const PointFunction& function) {
    return std::visit([](const auto& call) { return noises_of(call); }, function);
}

struct Counted {
    std::size_t noises = 0, others = 0;  ///< noises, and steps that are none
};

Counted count(const TextureGraph& graph, GraphOutput output) {
    Counted counted;
    const GraphValues values(graph, nullptr, output);
    for (const ValueStep& step : values.program().steps()) {
        const std::size_t noises =
            std::visit([](const auto& work) { return noises_of(work); }, step.work);
        counted.noises += noises;
        if (noises == 0) ++counted.others;
    }
    return counted;
}

}  // namespace

std::size_t graph_noises(const TextureGraph& graph, GraphOutput output) {
    return count(graph, output).noises;
}

double graph_cost(const TextureGraph& graph, GraphOutput output) {
    const Counted counted = count(graph, output);
    return std::max(1.0, double(counted.noises) + double(counted.others) / 8.0);
}

}  // namespace burl
