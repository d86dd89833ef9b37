#include "app/materialx/values/linear_form.h"

namespace burl::materialx {

namespace {

using Form = std::optional<LinearForm>;

LinearForm scaled(LinearForm form, double factor) {
    for (double& weight : form.weights) weight *= factor;
    form.offset *= factor;
    return form;
}

LinearForm sum(LinearForm a, const LinearForm& b) {
    for (std::size_t k = 0; k < a.weights.size(); ++k) a.weights[k] += b.weights[k];
    a.offset += b.offset;
    return a;
}

LinearForm unit(std::size_t weight) {
    LinearForm form;
    form.weights[weight] = 1.0;
    return form;
}

Form product(const LinearForm& a, const LinearForm& b) {
    if (b.is_constant()) return scaled(a, b.offset);
    if (a.is_constant()) return scaled(b, a.offset);
    return {};
}

std::size_t channel_index(const BuiltNode& split) {
    const auto name = split.parameters["channel"].get<std::string>();
    return name == "red" ? 0 : name == "green" ? 1 : 2;
}

/// The operation of the node, by MaterialX's name.
std::string operation_of(const BuiltNode& node) {
    if (node.parameters.contains("operation"))
        return node.parameters["operation"].get<std::string>();
    return node.node == "scale" ? "multiply" : node.node;
}

}  // namespace

std::optional<LinearForm> LinearForms::of(NodeRef ref, std::size_t channel) {
    const auto known = known_.find({ref, channel});
    if (known != known_.end()) return known->second;
    return known_[{ref, channel}] = found(ref, channel);
}

std::optional<LinearForm> LinearForms::found(NodeRef ref, std::size_t channel) {
    const BuiltNode& node = nodes_[ref];
    if (node.node.empty()) return LinearForm{{}, node.number};
    if (node.node == "point") return unit(2 + channel);
    // The one use that geometry.h makes of it gives texture coordinates.
    if (node.node == "mesh_uv") return channel < 2 ? unit(channel) : LinearForm{};
    if (node.node == "split") return of(node.inputs[0].second, channel_index(node));
    if (node.node == "combine") return of(node.inputs[channel].second, channel);
    return of_operation(operation_of(node), node, channel);
}

std::optional<LinearForm> LinearForms::of_operation(const std::string& operation,
                                                    const BuiltNode& node, std::size_t channel) {
    if (operation != "add" && operation != "subtract" && operation != "multiply" &&
        operation != "divide")
        return {};
    const Form a = of(node.inputs[0].second, channel), b = of(node.inputs[1].second, channel);
    if (!a || !b) return {};
    if (operation == "add") return sum(*a, *b);
    if (operation == "subtract") return sum(*a, scaled(*b, -1.0));
    if (operation == "multiply") return product(*a, *b);
    if (!b->is_constant() || b->offset == 0.0) return {};
    return scaled(*a, 1.0 / b->offset);
}

}  // namespace burl::materialx
