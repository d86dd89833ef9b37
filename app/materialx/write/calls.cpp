// Operations of vectors that work channel by channel are nodes of numbers. Where MaterialX 1.38 has
// no node of an operation that 1.39 has, it is written by those that both have.
#include "app/materialx/write/calls.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "procedural/batch/parameter.h"
#include "procedural/graph/table.h"

namespace burl::materialx {

namespace {

using Operands = std::vector<Operand>;

/// The word of an operation in a recipe, which is MaterialX's category.
std::string operation_of(std::string_view node, int choice) {
    return std::string(
        split_choices(find_node(node)->parameters().front().choices)[std::size_t(choice)]);
}

bool is_one_of(std::string_view word, std::string_view words) {
    const std::vector<std::string_view> all = split_choices(words);
    return std::ranges::find(all, word) != all.end();
}

std::string vector_of(std::span<const Operand> in, XmlNodes& nodes,
                      const std::string& type = "vector3") {
    return nodes.combined(type, {in.begin(), in.end()});
}

/// The distance of x from the nearest whole number.
Operand triangle_wave(const Operand& x, XmlNodes& nodes) {
    const Operand part = nodes.binary("modulo", nodes.unary("absval", x), {1.0});
    const Operand off = nodes.unary("absval", nodes.binary("subtract", part, {0.5}));
    return nodes.binary("subtract", {0.5}, off);
}

/// An operation of numbers that is called like a node.
Operand write_math(const std::string& operation, const Operand& a, const Operand& b,
                   const Operand& c, XmlNodes& nodes) {
    if (operation == "fract") return nodes.binary("modulo", a, {1.0});
    if (operation == "round") return nodes.unary("floor", nodes.binary("add", a, {0.5}));
    if (operation == "trianglewave") return triangle_wave(a, nodes);
    if (operation == "safepower")
        return nodes.binary("multiply", nodes.unary("sign", a),
                            nodes.binary("power", nodes.unary("absval", a), b));
    if (is_one_of(operation, "add|subtract|multiply|divide|modulo|power|atan2|min|max"))
        return nodes.binary(operation, a, b);
    if (is_one_of(operation, "clamp|smoothstep"))
        return nodes.number(operation, {{"in", a}, {"low", b}, {"high", c}});
    if (is_one_of(operation, "mix|burn|dodge|screen|overlay|difference|plus|minus"))
        return nodes.number(operation, {{"fg", b}, {"bg", a}, {"mix", c}});
    if (is_one_of(operation, "ifgreater|ifgreatereq|ifequal"))
        return nodes.choose(operation, a, b, {1.0}, {0.0});
    return nodes.unary(operation, a);
}

/// Three operands of a number, which operations of vectors that give one repeat.
Operands thrice(const std::string& node) {
    return Operands(3, Operand{0.0, node});
}

Operands write_vectors(const std::string& operation, const Operands& in, XmlNodes& nodes) {
    const std::span<const Operand> all(in);
    const auto a = [&](const char* name = "in", const char* type = "vector3") {
        return node_input(name, type, vector_of(all.first(3), nodes, type));
    };
    const auto b = [&](const char* name) {
        return node_input(name, "vector3", vector_of(all.subspan(3, 3), nodes));
    };
    const auto vector = [&](std::vector<XmlElement> inputs, const char* type = "vector3") {
        return components_of(nodes.add(operation, type, std::move(inputs)), type);
    };
    if (operation == "dotproduct" || operation == "luminance")
        return thrice(nodes.add("dotproduct", "float", {a("in1"), b("in2")}));
    if (operation == "distance") {
        const std::string way = nodes.add("subtract", "vector3", {a("in1"), b("in2")});
        return thrice(nodes.add("magnitude", "float", {node_input("in", "vector3", way)}));
    }
    if (operation == "magnitude") return thrice(nodes.add(operation, "float", {a()}));
    if (operation == "crossproduct") return vector({a("in1"), b("in2")});
    if (operation == "rotate3d") return vector({a(), nodes.input("amount", in[6]), b("axis")});
    if (operation == "reflect") return vector({a(), b("normal")});
    if (operation == "refract") return vector({a(), b("normal"), nodes.input("ior", in[6])});
    if (operation == "normalize") return vector({a()});
    if (is_one_of(operation, "rgbtohsv|hsvtorgb")) return vector({a("in", "color3")}, "color3");
    Operands channels;
    for (std::size_t c = 0; c < 3; ++c)
        channels.push_back(write_math(operation, in[c], in[3 + c], in[6 + c], nodes));
    return channels;
}

/// A whole number of octaves, which MaterialX wants as an integer.
XmlElement octaves_input(const Operand& octaves, XmlNodes& nodes) {
    if (octaves.is_constant())
        return value_input("octaves", "integer", fmt::format("{}", int(octaves.constant)));
    return node_input("octaves", "integer",
                      nodes.add("floor", "integer", {nodes.input("in", octaves)}));
}

Operands write_noise(const MaterialXCall& call, const Operands& in, XmlNodes& nodes) {
    const bool flat = call.dimensions == 2;
    const auto named = [&](const char* name) { return fmt::format("{}{}d", name, flat ? 2 : 3); };
    const std::string place = flat ? "vector2" : "vector3";
    std::vector<XmlElement> inputs{
        node_input(flat ? "texcoord" : "position", place,
                   vector_of(std::span(in).first(flat ? 2 : 3), nodes, place))};
    std::string category = named("noise");
    if (call.function == MaterialXFunction::fractal) {
        category = named("fractal");
        inputs.push_back(octaves_input(in[3], nodes));
        inputs.push_back(nodes.input("lacunarity", in[4]));
        inputs.push_back(nodes.input("diminish", in[5]));
    } else if (call.function == MaterialXFunction::worley) {
        category = named("worleynoise");
        inputs.push_back(nodes.input("jitter", in[3]));
        if (call.choice == 1) inputs.push_back(value_input("style", "integer", "1"));
    } else if (call.function == MaterialXFunction::cell_noise && call.results == 1) {
        category = named("cellnoise");
    } else if (call.function == MaterialXFunction::cell_noise) {
        // Three numbers of a cell are what Worley's noise gives of points in the middles of cells.
        category = named("worleynoise");
        inputs.push_back(number_input("jitter", 0.0));
        inputs.push_back(value_input("style", "integer", "1"));
    }
    if (call.results == 1) return {{0.0, nodes.add(category, "float", std::move(inputs))}};
    return components_of(nodes.add(category, "vector3", std::move(inputs)), "vector3");
}

}  // namespace

std::vector<Operand> write_call(const MaterialXCall& call, const std::vector<Operand>& in,
                                XmlNodes& nodes) {
    Operands all = in;
    all.resize(most_materialx_inputs);
    if (call.function == MaterialXFunction::math)
        return {
            write_math(operation_of("materialx_math", call.choice), all[0], all[1], all[2], nodes)};
    if (call.function == MaterialXFunction::vector_math)
        return write_vectors(operation_of("materialx_vector_math", call.choice), all, nodes);
    return write_noise(call, all, nodes);
}

}  // namespace burl::materialx
