#include "app/materialx/values/builder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/materialx/values/fold.h"

namespace burl::materialx {

namespace {

constexpr std::array<const char*, 3> channel_names{"red", "green", "blue"};
constexpr std::array<const char*, 3> input_names{"a", "b", "c"};

/// A node of numbers that does what an operation of MaterialX does.
struct OwnNode {
    std::string_view operation, node;
    bool unary = false;
};

/// The operations that have a node of their own, which is faster than `materialx_math` and has
/// gradients.
constexpr std::array own_nodes{OwnNode{"add", "add"},           OwnNode{"subtract", "subtract"},
                               OwnNode{"multiply", "multiply"}, OwnNode{"divide", "divide"},
                               OwnNode{"min", "min"},           OwnNode{"max", "max"},
                               OwnNode{"sin", "sin", true},     OwnNode{"absval", "abs", true},
                               OwnNode{"floor", "floor", true}, OwnNode{"fract", "fract", true}};

NodeInputs named_inputs(const std::vector<NodeRef>& inputs) {
    NodeInputs named;
    for (std::size_t k = 0; k < inputs.size(); ++k) named.emplace_back(input_names[k], inputs[k]);
    return named;
}

}  // namespace

NodeRef NodeBuilder::push(const std::string& key, BuiltNode node) {
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    node.label = label_;
    nodes_.push_back(std::move(node));
    return known_[key] = NodeRef(nodes_.size() - 1);
}

NodeRef NodeBuilder::number(double value) {
    const double plain = value == 0.0 ? 0.0 : value;  // no -0
    return push(fmt::format("{}", plain), {"", plain});
}

NodeRef NodeBuilder::node(const std::string& name, bool color, NodeInputs inputs, Json parameters) {
    std::string key = name + parameters.dump();
    for (const auto& [input, ref] : inputs) key += fmt::format(" {}={}", input, ref);
    return push(key, {name, 0.0, color, std::move(inputs), std::move(parameters)});
}

std::optional<double> NodeBuilder::constant(NodeRef ref) const {
    if (!nodes_[ref].node.empty()) return {};
    return nodes_[ref].number;
}

std::optional<NodeRef> NodeBuilder::folded(std::string_view operation,
                                           const std::vector<NodeRef>& inputs) {
    std::vector<double> constants;
    for (const NodeRef input : inputs)
        if (const auto value = constant(input)) constants.push_back(*value);
    if (constants.size() == inputs.size()) {
        const auto result = folded_constant(operation, constants);
        return result ? std::optional(number(*result)) : std::nullopt;
    }
    const auto is = [&](std::size_t k, double value) { return constant(inputs[k]) == value; };
    if (operation == "add" && is(0, 0.0)) return inputs[1];
    if ((operation == "add" || operation == "subtract") && is(1, 0.0)) return inputs[0];
    if (operation == "multiply" && is(0, 1.0)) return inputs[1];
    if ((operation == "multiply" || operation == "divide" || operation == "power") && is(1, 1.0))
        return inputs[0];
    if (operation == "multiply" && (is(0, 0.0) || is(1, 0.0))) return number(0.0);
    if (operation == "mix" && (is(2, 0.0) || inputs[0] == inputs[1])) return inputs[0];
    if (operation == "mix" && is(2, 1.0)) return inputs[1];
    return {};
}

std::optional<NodeRef> NodeBuilder::with_constants(std::string_view operation,
                                                   const std::vector<NodeRef>& inputs) {
    const auto constant_at = [&](std::size_t k) { return constant(inputs[k]).value_or(1e9); };
    if (operation == "power") {
        const double exponent = constant_at(1);
        if (exponent < 0.0 || exponent > 64.0) return {};
        return node("power", false, {{"input", inputs[0]}}, {{"exponent", exponent}});
    }
    if (operation != "clamp" && operation != "smoothstep") return {};
    const double low = constant_at(1), high = constant_at(2);
    if (std::max(std::abs(low), std::abs(high)) > 1e6 || low >= high) return {};
    return node(std::string(operation), false, {{"input", inputs[0]}},
                {{"low", low}, {"high", high}});
}

NodeRef NodeBuilder::math(std::string_view operation, std::vector<NodeRef> inputs) {
    if (const auto known = folded(operation, inputs)) return *known;
    const auto own = std::ranges::find(own_nodes, operation, &OwnNode::operation);
    if (own != own_nodes.end())
        return node(std::string(own->node), false,
                    own->unary ? NodeInputs{{"input", inputs[0]}} : named_inputs(inputs));
    if (operation == "mix")
        return node("mix", false, {{"a", inputs[0]}, {"b", inputs[1]}, {"amount", inputs[2]}});
    if (const auto simple = with_constants(operation, inputs)) return *simple;
    return node("materialx_math", false, named_inputs(inputs), {{"operation", operation}});
}

NodeRef NodeBuilder::vector_math(std::string_view operation, std::vector<NodeRef> inputs) {
    if (const auto known = folded(operation, inputs)) return *known;
    if (operation == "multiply") return node("scale", true, {{"a", inputs[0]}, {"b", inputs[1]}});
    if (operation == "mix" && !is_color(inputs[2]))
        return node("mix", true, {{"a", inputs[0]}, {"b", inputs[1]}, {"amount", inputs[2]}});
    return node("materialx_vector_math", true, named_inputs(inputs), {{"operation", operation}});
}

NodeRef NodeBuilder::channel(NodeRef from, std::size_t index) {
    const BuiltNode& node_from = nodes_[from];
    if (!node_from.color) return from;
    if (node_from.node == "combine") return node_from.inputs[index].second;
    return node("split", false, {{"input", from}}, {{"channel", channel_names[index]}});
}

NodeRef NodeBuilder::combined(const std::vector<NodeRef>& channels) {
    if (channels[0] == channels[1] && channels[1] == channels[2]) return channels[0];
    const BuiltNode& first = nodes_[channels[0]];
    if (first.node == "split") {
        const NodeRef whole = first.inputs[0].second;
        const auto is_channel = [&](std::size_t k) { return channels[k] == channel(whole, k); };
        if (is_channel(0) && is_channel(1) && is_channel(2)) return whole;
    }
    return node("combine", true,
                {{"red", channels[0]}, {"green", channels[1]}, {"blue", channels[2]}});
}

}  // namespace burl::materialx
