#include "app/materialx/shader_inputs.h"

#include <algorithm>

#include <fmt/format.h>

namespace burl::materialx {

NodeRef ShaderInputs::number(std::string_view name, double otherwise) const {
    const auto given = reader_.input(*shader_.node, name, *shader_.scope, Type::number);
    return given ? values().part(*given, 0) : values().nodes.number(otherwise);
}

Value ShaderInputs::color(std::string_view name, double otherwise) const {
    const auto given = reader_.input(*shader_.node, name, *shader_.scope, Type::color3);
    return given.value_or(values().filled(Type::color3, otherwise));
}

Value ShaderInputs::weighted(std::string_view weight, double weight_otherwise,
                             std::string_view name, double otherwise) const {
    return values().apply(
        "multiply", Type::color3,
        {color(name, otherwise), values().number(number(weight, weight_otherwise))});
}

bool ShaderInputs::is_zero(std::string_view name, double otherwise) const {
    return values().nodes.constant(number(name, otherwise)) == 0.0;
}

bool ShaderInputs::is_lost(const LostInput& input) const {
    const Target target = reader_.target(*shader_.node, input.name, *shader_.scope);
    if (!target.node && !target.holder) return false;
    if (!input.weight.empty() && is_zero(input.weight, 0.0)) return false;
    if (input.otherwise.empty())
        return !target.node || (target.node->tag != "normal" && target.node->tag != "tangent");
    const auto given = reader_.input(*shader_.node, input.name, *shader_.scope);
    return !given || values().constants_of(*given) != input.otherwise;
}

void ShaderInputs::note_lost(const std::vector<LostInput>& inputs,
                             std::span<const std::string_view> held) const {
    std::vector<std::string_view> names;
    for (const LostInput& one : inputs)
        if (is_lost(one)) names.push_back(one.name);
    if (!names.empty()) lose(fmt::format("a recipe has no channel for {}", fmt::join(names, ", ")));
    for (const Element& one : shader_.node->children) {
        const std::string name = one.name();
        if (one.tag != "input" || std::ranges::count(held, name) > 0 ||
            std::ranges::count(inputs, name, &LostInput::name) > 0)
            continue;
        lose(fmt::format("{} has no input {}, which is left out", shader_.node->tag, name));
    }
}

void ShaderInputs::lose(const std::string& sentence) const {
    reader_.lose(fmt::format("{}{}: {}", shader_.scope->path, shader_.node->name(), sentence));
}

}  // namespace burl::materialx
