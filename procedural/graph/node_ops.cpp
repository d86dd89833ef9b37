#include "procedural/graph/node_ops.h"

#include <algorithm>

#include "procedural/graph/masks.h"

namespace burl {

NodeOps::NodeOps(const TextureGraph& graph, std::size_t number,
                 std::span<const std::vector<Register>> channels, GraphProgram& program)
    : NodeParameters(graph.nodes[number]),
      graph_(graph),
      number_(std::uint32_t(number)),
      channels_(channels),
      program_(program) {}

Register NodeOps::input(std::size_t k, std::size_t c) {
    const std::vector<Register>& given = channels_[self().inputs[k]];
    if (c < given.size()) return given[c];
    return c < 3 ? given[0] : constant(1.0);
}

std::vector<Register> NodeOps::numbers(std::size_t first) {
    const std::span<const NodeInput> all = type_of(self()).inputs();
    std::vector<Register> result;
    for (std::size_t k = first; k < all.size(); ++k)
        for (std::size_t c = 0; c < (all[k].wire == Wire::color ? 3 : 1); ++c)
            result.push_back(input(k, c));
    return result;
}

/// The mask is read like a function of the point, for it differs from texel to texel.
Register NodeOps::mask(std::size_t c) {
    const NodeMask& own = type_of(self()).mask;
    const auto begin = self().parameters.begin();
    const GraphMask wanted{own.kind, {begin, begin + std::ptrdiff_t(own.numbers)}, c};
    const std::vector<GraphMask> all = graph_masks(graph_);
    return apply(MaskRead{std::size_t(std::ranges::find(all, wanted) - all.begin())}, {0});
}

Register NodeOps::along(const Vec3d& d, double offset) {
    return apply(ValueOp::affine, point(), {d.x, d.y, d.z, offset});
}

std::vector<Register> NodeOps::moved(const Affine3& map) {
    const Mat3d rows = glm::transpose(map.linear);
    return {along(rows[0], map.offset.x), along(rows[1], map.offset.y),
            along(rows[2], map.offset.z)};
}

std::vector<Register> NodeOps::add(GraphWork work, std::vector<Register> inputs,
                                   std::size_t count) {
    GraphStep& step =
        program_.steps.emplace_back(GraphStep{std::move(work), std::move(inputs), {}, number_});
    for (std::size_t i = 0; i < count; ++i) step.outputs.push_back(Register(program_.registers++));
    return step.outputs;
}

Register NodeOps::apply(GraphWork work, std::vector<Register> inputs) {
    return add(std::move(work), std::move(inputs)).front();
}

Register NodeOps::apply(ValueOp op, std::vector<Register> inputs, const std::array<double, 4>& p) {
    return apply(ValueOperation{op, p}, std::move(inputs));
}

Register NodeOps::clamped(Register a, double low, double high) {
    return minimum(constant(high), maximum(constant(low), a));
}

Register NodeOps::share(Register a, double low, double high) {
    if (low == high) return apply(ValueOp::at_least, {a}, {low});
    // The difference comes first, so that the share of low is exactly 0.
    return linear(1.0 / (high - low), linear(1.0, a, -low));
}

std::vector<Register> NodeOps::blend(Register weight) {
    std::vector<Register> result;
    for (std::size_t c = 0; c < channels(); ++c)
        result.push_back(lerp(weight, input(0, c), input(1, c)));
    return result;
}

std::vector<Register> NodeOps::opaque(GraphWork colors, std::vector<Register> inputs) {
    std::vector<Register> result = add(std::move(colors), std::move(inputs), 3);
    result.push_back(constant(1.0));
    return result;
}

std::vector<Register> NodeOps::with_alpha(GraphWork colors, GraphWork alpha,
                                          const std::vector<Register>& inputs) {
    std::vector<Register> result = add(std::move(colors), inputs, 3);
    result.push_back(add(std::move(alpha), inputs, 3).front());
    return result;
}

}  // namespace burl
