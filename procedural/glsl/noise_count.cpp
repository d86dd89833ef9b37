#include "procedural/glsl/noise_count.h"

#include "procedural/graph/values.h"

namespace burl {

namespace {

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
    return shader_noises(slope.graph->graph(), GraphOutput::color);
}

}  // namespace

std::size_t shader_noises(const TextureGraph& graph, GraphOutput output) {
    std::size_t count = 0;
    const GraphValues values(graph, nullptr, output);
    for (const ValueStep& step : values.program().steps())
        count += std::visit([](const auto& work) { return noises_of(work); }, step.work);
    return count;
}

}  // namespace burl
