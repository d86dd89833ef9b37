#include "app/materialx/values/value.h"

#include <algorithm>

namespace burl::materialx {

Value Arithmetic::constant(Type type, const std::vector<double>& numbers) {
    Value value{type};
    for (std::size_t k = 0; k < size_of(type); ++k) value.parts[k] = nodes.number(numbers[k]);
    return value;
}

Value Arithmetic::filled(Type type, double number) {
    return constant(type, std::vector<double>(size_of(type), number));
}

Value Arithmetic::number(NodeRef ref, Type type) const {
    return of_parts(type, {ref});
}

Value Arithmetic::of_parts(Type type, const std::vector<NodeRef>& parts) const {
    Value value{type};
    for (std::size_t k = 0; k < size_of(type); ++k) value.parts[k] = parts[k];
    return value;
}

Value Arithmetic::of_color(Type type, NodeRef color, std::optional<NodeRef> fourth) {
    if (is_number(type)) return number(nodes.channel(color, 0), type);
    Value value{type, color};
    value.parts[3] = fourth;
    return value;
}

NodeRef Arithmetic::part(const Value& value, std::size_t index) {
    if (is_number(value.type)) return *value.parts[0];
    if (value.parts[index]) return *value.parts[index];
    if (!value.packed || index > 2) return nodes.number(0.0);
    return nodes.channel(*value.packed, index);
}

std::vector<NodeRef> Arithmetic::parts_of(const Value& value) {
    std::vector<NodeRef> all;
    for (std::size_t k = 0; k < size_of(value.type); ++k) all.push_back(part(value, k));
    return all;
}

NodeRef Arithmetic::packed(const Value& value) {
    if (is_number(value.type)) return *value.parts[0];
    if (value.packed) return *value.packed;
    std::vector<NodeRef> channels = parts_of(value);
    // Where both components of a vector2 are equal, so is the third: one number stands for all.
    if (value.type == Type::vector2)
        channels.push_back(channels[0] == channels[1] ? channels[0] : nodes.number(0.0));
    return nodes.combined(channels);
}

NodeRef Arithmetic::vector(const Value& value) {
    if (value.type != Type::vector2) return packed(value);
    return nodes.combined({part(value, 0), part(value, 1), nodes.number(0.0)});
}

std::optional<std::vector<double>> Arithmetic::constants_of(const Value& value) {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < size_of(value.type); ++k) {
        if (!value.parts[k] && nodes.is_color(*value.packed)) return {};
        const auto number_here = nodes.constant(part(value, k));
        if (!number_here) return {};
        numbers.push_back(*number_here);
    }
    return numbers;
}

/// Whether the arguments are better computed component by component: all are constants.
bool Arithmetic::can_stay_apart(const std::vector<Value>& arguments) {
    return std::ranges::all_of(arguments,
                               [&](const Value& one) { return constants_of(one).has_value(); });
}

Value Arithmetic::apply(std::string_view operation, Type type,
                        const std::vector<Value>& arguments) {
    const auto by_component = [&](std::size_t k) {
        std::vector<NodeRef> inputs;
        for (const Value& one : arguments) inputs.push_back(part(one, k));
        return nodes.math(operation, inputs);
    };
    if (is_number(type) || can_stay_apart(arguments)) {
        Value result{type};
        for (std::size_t k = 0; k < size_of(type); ++k) result.parts[k] = by_component(k);
        return result;
    }
    std::vector<NodeRef> inputs;
    for (const Value& one : arguments) inputs.push_back(packed(one));
    const bool grey =
        std::ranges::none_of(inputs, [&](NodeRef one) { return nodes.is_color(one); });
    Value result{type, grey ? nodes.math(operation, inputs) : nodes.vector_math(operation, inputs)};
    if (size_of(type) == 4) result.parts[3] = by_component(3);
    return result;
}

NodeRef Arithmetic::number_of(std::string_view operation, const std::vector<Value>& arguments) {
    std::vector<NodeRef> inputs;
    for (const Value& one : arguments) inputs.push_back(vector(one));
    return nodes.channel(nodes.vector_math(operation, inputs), 0);
}

}  // namespace burl::materialx
