#include "app/materialx/relief.h"

#include <fmt/format.h>

namespace burl::materialx {

namespace {

NodeRef number_at(Reader& reader, const Target& at, std::string_view name, double otherwise) {
    const auto given = reader.input(*at.node, name, *at.scope, Type::number);
    return given ? reader.values.part(*given, 0) : reader.nodes.number(otherwise);
}

/// The height of a node `displacement`.
std::optional<NodeRef> displacement_height(const ShaderInputs& inputs, const Target& at) {
    Reader& reader = inputs.reader();
    if (at.node->tag != "displacement") {
        reader.lose(fmt::format("{}{}: {} is not read, the surface stays where it is",
                                at.scope->path, at.node->name(), at.node->tag));
        return {};
    }
    const auto given = reader.input(*at.node, "displacement", *at.scope);
    if (!given || !is_number(given->type)) {
        if (given)
            reader.lose(
                fmt::format("{}{}: a displacement by vectors is left out, a recipe has a "
                            "height alone",
                            at.scope->path, at.node->name()));
        return {};
    }
    return reader.nodes.math("multiply",
                             {reader.values.part(*given, 0), number_at(reader, at, "scale", 1.0)});
}

/// The height that a normal is made of; none where it is made of none, which is noted.
std::optional<NodeRef> normal_height(const ShaderInputs& inputs, std::string_view name) {
    Reader& reader = inputs.reader();
    const Target at = reader.target(*inputs.shader().node, name, *inputs.shader().scope);
    if (!at.node || at.node->tag == "normal") return {};
    if (at.node->tag == "bump")
        return reader.nodes.math("multiply", {number_at(reader, at, "height", 0.0),
                                              number_at(reader, at, "scale", 1.0)});
    if (at.node->tag == "normalmap") {
        const Target from = reader.target(*at.node, "in", *at.scope);
        if (from.node && from.node->tag == "heighttonormal") {
            const NodeRef height = reader.nodes.math(
                "multiply",
                {number_at(reader, from, "in", 0.0), number_at(reader, from, "scale", 1.0)});
            return reader.nodes.math("multiply", {height, number_at(reader, at, "scale", 1.0)});
        }
    }
    inputs.lose(
        fmt::format("{} is left out, since {}{} ({}) gives a normal and a recipe has "
                    "heights alone",
                    name, at.scope->path, at.node->name(), at.node->tag));
    return {};
}

}  // namespace

std::optional<NodeRef> read_height(const ShaderInputs& inputs, std::string_view normal,
                                   const Target& displacement) {
    std::optional<NodeRef> height;
    if (displacement.node) height = displacement_height(inputs, displacement);
    const auto bumps = normal_height(inputs, normal);
    if (!bumps) return height;
    if (!height) return bumps;
    return inputs.values().nodes.math("add", {*height, *bumps});
}

}  // namespace burl::materialx
