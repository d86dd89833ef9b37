#include "app/materialx/nodes.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/materialx/values/convert.h"

namespace burl::materialx {

Value NodeCall::in(std::string_view name, const Value& otherwise) const {
    return reader.input(node, name, scope, otherwise.type).value_or(otherwise);
}

Value NodeCall::any(std::string_view name) const {
    return reader.input(node, name, scope).value_or(values().filled(Type::number, 0.0));
}

Value NodeCall::in(std::string_view name, Type type_left_out, double otherwise) const {
    return in(name, values().filled(type_left_out, otherwise));
}

Value NodeCall::in(std::string_view name, double otherwise) const {
    return in(name, type, otherwise);
}

NodeRef NodeCall::number(std::string_view name, double otherwise) const {
    return values().part(in(name, Type::number, otherwise), 0);
}

std::optional<std::vector<double>> NodeCall::constants(std::string_view name,
                                                       const std::vector<double>& otherwise) const {
    const auto given = reader.input(node, name, scope);
    if (!given) return otherwise;
    return values().constants_of(*given);
}

std::optional<double> NodeCall::constant(std::string_view name, double otherwise) const {
    const auto given = constants(name, {otherwise});
    if (!given) return {};
    return given->front();
}

std::string NodeCall::text(std::string_view name) const {
    const Target target = reader.target(node, name, scope);
    return target.holder ? target.holder->text("value") : "";
}

Value NodeCall::geometry(std::string_view name, const char* property) const {
    const Type wanted = property == std::string_view("UV0") ? Type::vector2 : Type::vector3;
    const auto given = reader.input(node, name, scope, wanted);
    if (!given) return reader.geometry(property, node, scope);
    return is_number(given->type) ? converted(values(), *given, wanted) : *given;
}

Value NodeCall::refused(const std::string& reason) const {
    return reader.refused(node, type, scope, reason);
}

Value NodeCall::varies(std::string_view name) const {
    return refused(fmt::format("{} with a \"{}\" that varies is not read", node.tag, name));
}

Value NodeCall::made(NodeRef ref) const {
    if (!is_number(type)) return refused("it makes one number, its type has several");
    return values().number(ref, type);
}

NodeFunction function_of(std::string_view category) {
    for (const auto rows :
         {math_rows(), vector_rows(), channel_rows(), color_rows(), blend_rows(), noise_rows(),
          unified_rows(), choice_rows(), ramp_rows(), place_rows(), image_rows()}) {
        const auto row = std::ranges::find(rows, category, &NodeRow::category);
        if (row != rows.end()) return row->function;
    }
    return nullptr;
}

}  // namespace burl::materialx
