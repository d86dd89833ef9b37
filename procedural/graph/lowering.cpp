#include "procedural/graph/lowering.h"

#include "procedural/graph/values.h"

namespace burl {

double LoweringCall::parameter(std::string_view key, std::size_t component) const {
    NodeCall call;
    call.node = node;
    return call.parameter(key, component);
}

Vec3d LoweringCall::vector(std::string_view key) const {
    return {parameter(key, 0), parameter(key, 1), parameter(key, 2)};
}

Register LoweringCall::input(std::size_t k, std::size_t c) const {
    const std::vector<Register>& channels = inputs[k]->channels;
    if (c < channels.size()) return channels[c];
    return c < 3 ? channels[0] : program->constant(1.0);
}

Register LoweringCall::along(const Vec3d& d, double offset) const {
    const Vec3d weights = d * place.map.linear;
    const double constant = glm::dot(d, place.map.offset) + offset;
    std::vector<int> used;
    for (int i = 0; i < 3; ++i)
        if (weights[i] != 0.0) used.push_back(i);
    if (used.empty()) return program->constant(constant);
    const auto base = [&](int i) { return place.base[std::size_t(i)]; };
    if (used.size() == 1) return linear(weights[used[0]], base(used[0]), constant);
    if (used.size() == 2)
        return program->add(ValueOp::combine, {base(used[0]), base(used[1])},
                            {weights[used[0]], weights[used[1]], constant});
    return program->add(ValueOp::affine, {base(0), base(1), base(2)},
                        {weights.x, weights.y, weights.z, constant});
}

Register LoweringCall::axis(int i) const {
    Vec3d d(0.0);
    d[i] = 1.0;
    return along(d);
}

Register LoweringCall::linear(double p, Register a, double q) const {
    if (p == 1.0 && q == 0.0) return a;
    return program->add(ValueOp::linear, {a}, {p, q});
}

Register LoweringCall::add(Register a, Register b) const {
    if (const double* x = program->constant_of(a)) return linear(1.0, b, *x);
    if (const double* x = program->constant_of(b)) return linear(1.0, a, *x);
    return program->add(ValueOp::add, {a, b});
}

Register LoweringCall::multiply(Register a, Register b) const {
    if (const double* x = program->constant_of(a)) return linear(*x, b);
    if (const double* x = program->constant_of(b)) return linear(*x, a);
    return program->add(ValueOp::multiply, {a, b});
}

Register LoweringCall::lerp(Register w, Register a, Register b) const {
    if (program->same(a, b)) return a;
    const double *low = program->constant_of(a), *high = program->constant_of(b);
    if (low && high) return linear(*high - *low, w, *low);
    return program->add(ValueOp::lerp, {w, a, b});
}

LoweredNode LoweringCall::blend(Register weight) const {
    LoweredNode result;
    for (std::size_t c = 0; c < std::size_t(node->wire); ++c)
        result.channels.push_back(lerp(weight, input(0, c), input(1, c)));
    return result;
}

namespace {

Lowering lowering_of(std::string_view name) {
    for (const auto& table : {pattern_lowerings(), noise_lowerings()})
        for (const NamedLowering& known : table)
            if (known.node == name) return known.lower;
    return nullptr;
}

}  // namespace

GraphValues::GraphValues(const TextureGraph& graph, const Skips* skips) : program_(skips) {
    // The first element is the solid point.
    std::vector<LoweredNode> lowered(1);
    for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
        const GraphNode& node = graph.nodes[n];
        LoweringCall call;
        call.graph = &graph;
        call.node = &node;
        for (std::size_t k = 0; k < node.inputs.size(); ++k)
            call.inputs[k] = &lowered[node.inputs[k]];
        call.place = lowered[node.place].place;
        call.program = &program_;
        program_.begin_node(std::uint32_t(n));
        lowered.push_back(lowering_of(type_of(node).name)(call));
    }
    std::vector<Register> results = lowered.back().channels;
    if (results.size() == 1) results.resize(3, results.front());
    // Colours are over black, so alpha is dropped.
    results.resize(3);
    results_ = program_.finish(results);
}

std::array<const double*, 3> GraphValues::operator()(std::size_t count, Scratch& scratch) const {
    program_.run(count, scratch);
    return {scratch[results_[0]], scratch[results_[1]], scratch[results_[2]]};
}

Vec3d GraphValues::operator()(const Vec3d& point, Scratch& scratch) const {
    for (int axis = 0; axis < 3; ++axis) scratch[Register(axis)][0] = point[axis];
    const auto color = (*this)(1, scratch);
    return {*color[0], *color[1], *color[2]};
}

}  // namespace burl
