#include "app/materialx/write/nodes.h"

#include <algorithm>

#include <fmt/format.h>

namespace burl::materialx {

namespace {

std::size_t components(const std::string& type) {
    return std::size_t(type.back() - '0');
}

/// The three operands' node where they are a vector's components in their order; else empty.
std::string common_node(const std::string& type, const std::vector<Operand>& operands) {
    for (std::size_t i = 0; i < operands.size(); ++i)
        if (operands[i].node != operands[0].node || operands[i].type != type ||
            operands[i].component != int(i))
            return "";
    return operands[0].node;
}

}  // namespace

std::vector<Operand> components_of(const std::string& node, const std::string& type) {
    std::vector<Operand> all;
    for (std::size_t i = 0; i < components(type); ++i) all.push_back({0.0, node, type, int(i)});
    return all;
}

std::string XmlNodes::add(const std::string& category, const std::string& type,
                          std::vector<XmlElement> inputs) {
    std::string key = category + ' ' + type;
    for (const XmlElement& input : inputs)
        for (const auto& [name, value] : input.attributes) key += '\n' + name + '\n' + value;
    const auto [known, is_new] = names_.try_emplace(key);
    if (!is_new) return known->second;
    known->second = fmt::format("{}_{}", category, ++numbers_[category]);
    nodes_.push_back({category, {{"name", known->second}, {"type", type}}, std::move(inputs)});
    nodes_.back().comment = std::exchange(comment_, {});
    return known->second;
}

std::string XmlNodes::extracted(const Operand& operand) {
    return add("extract", "float",
               {node_input("in", operand.type, operand.node),
                value_input("index", "integer", fmt::format("{}", operand.component))});
}

XmlElement XmlNodes::input(const std::string& name, const Operand& operand) {
    if (operand.is_constant()) return number_input(name, operand.constant);
    return node_input(name, "float", operand.type.empty() ? operand.node : extracted(operand));
}

Operand XmlNodes::number(const std::string& category, const OperandInputs& inputs) {
    std::vector<XmlElement> elements;
    for (const auto& [name, operand] : inputs) elements.push_back(input(name, operand));
    return {0.0, add(category, "float", std::move(elements))};
}

std::string XmlNodes::combined(const std::string& type, const std::vector<Operand>& parts) {
    if (std::string known = common_node(type, parts); !known.empty()) return known;
    if (std::ranges::all_of(parts, &Operand::is_constant)) {
        std::string text;
        for (const Operand& part : parts)
            text += fmt::format("{}{}", text.empty() ? "" : ", ", value_text(part.constant));
        return add("constant", type, {value_input("value", type, text)});
    }
    std::vector<XmlElement> elements;
    for (std::size_t i = 0; i < parts.size(); ++i)
        elements.push_back(input(fmt::format("in{}", i + 1), parts[i]));
    return add(fmt::format("combine{}", parts.size()), type, std::move(elements));
}

Operand XmlNodes::binary(const std::string& category, const Operand& in1, const Operand& in2) {
    const double a = in1.constant, b = in2.constant;
    const bool fixed = in1.is_constant() && in2.is_constant();
    if (fixed && category == "min") return {std::min(a, b)};
    if (fixed && category == "max") return {std::max(a, b)};
    if (const bool sum = category == "add"; sum || category == "multiply") {
        const double idle = sum ? 0.0 : 1.0;
        if (fixed) return {sum ? a + b : a * b};
        if (in1.is_constant() && a == idle) return in2;
        if (in2.is_constant() && b == idle) return in1;
    }
    return number(category, {{"in1", in1}, {"in2", in2}});
}

Operand XmlNodes::times(const Operand& operand, double factor) {
    return binary("multiply", operand, {factor});
}

Operand XmlNodes::sum(const std::vector<Operand>& operands, const std::vector<double>& factors,
                      double constant) {
    Operand total;
    bool empty = true;
    const auto add_term = [&](const Operand& term) {
        if (term.is_constant()) {
            constant += term.constant;
            return;
        }
        total = empty ? term : binary("add", total, term);
        empty = false;
    };
    if (const std::string vector = operands.size() == 3 ? common_node("vector3", operands) : "";
        !vector.empty()) {
        const std::string d = fmt::format("{}, {}, {}", value_text(factors[0]),
                                          value_text(factors[1]), value_text(factors[2]));
        add_term(
            {0.0, add("dotproduct", "float",
                      {node_input("in1", "vector3", vector), value_input("in2", "vector3", d)})});
    } else {
        for (std::size_t i = 0; i < operands.size(); ++i)
            if (factors[i] != 0.0) add_term(times(operands[i], factors[i]));
    }
    if (empty) return {constant};
    return binary("add", total, {constant});
}

}  // namespace burl::materialx
