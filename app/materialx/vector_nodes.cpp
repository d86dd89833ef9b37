// Operations of vectors as a whole, and turns of them.
#include <array>
#include <numbers>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {

/// The dot product of all components.
NodeRef dot_product(Arithmetic& values, const Value& a, const Value& b) {
    const NodeRef three = values.number_of("dotproduct", {a, b});
    if (size_of(a.type) < 4) return three;
    const NodeRef fourth = values.nodes.math("multiply", {values.part(a, 3), values.part(b, 3)});
    return values.nodes.math("add", {three, fourth});
}

NodeRef length_of(Arithmetic& values, const Value& value) {
    if (size_of(value.type) < 4) return values.number_of("magnitude", {value});
    return values.nodes.math("sqrt", {dot_product(values, value, value)});
}

Value dotproduct(const NodeCall& call) {
    const Value a = call.any("in1");
    return call.made(dot_product(call.values(), a, call.in("in2", a.type, 0.0)));
}

Value magnitude(const NodeCall& call) {
    return call.made(length_of(call.values(), call.any("in")));
}

Value distance(const NodeCall& call) {
    const Value a = call.any("in1");
    const Value way = call.values().apply("subtract", a.type, {a, call.in("in2", a.type, 0.0)});
    return call.made(length_of(call.values(), way));
}

Value normalize(const NodeCall& call) {
    const Value from = call.in("in", 0.0);
    Arithmetic& values = call.values();
    if (size_of(call.type) < 4)
        return values.of_color(call.type,
                               call.nodes().vector_math("normalize", {values.vector(from)}));
    return values.apply("divide", call.type, {from, values.number(length_of(values, from))});
}

Value crossproduct(const NodeCall& call) {
    const NodeRef a = call.values().vector(call.in("in1", 0.0));
    const NodeRef b = call.values().vector(call.in("in2", 0.0));
    return call.values().of_color(call.type, call.nodes().vector_math("crossproduct", {a, b}));
}

/// A vector turned clockwise by a number of degrees.
Value rotate2d(const NodeCall& call) {
    NodeBuilder& nodes = call.nodes();
    const Value from = call.in("in", 0.0);
    const NodeRef angle = nodes.math(
        "multiply", {call.number("amount", 0.0), nodes.number(std::numbers::pi / 180.0)});
    return turned(call.values(), from, angle);
}

Value rotate3d(const NodeCall& call) {
    Arithmetic& values = call.values();
    const Value axis = call.in("axis", values.constant(Type::vector3, {0.0, 1.0, 0.0}));
    const NodeRef result = call.nodes().vector_math(
        "rotate3d",
        {values.vector(call.in("in", 0.0)), values.vector(axis), call.number("amount", 0.0)});
    return values.of_color(call.type, result);
}

Value reflect(const NodeCall& call) {
    Arithmetic& values = call.values();
    const Value from = call.in("in", values.constant(Type::vector3, {1.0, 0.0, 0.0}));
    const NodeRef normal = values.vector(call.geometry("normal", "Nworld"));
    return values.of_color(call.type,
                           call.nodes().vector_math("reflect", {values.vector(from), normal}));
}

Value refract(const NodeCall& call) {
    Arithmetic& values = call.values();
    const Value from = call.in("in", values.constant(Type::vector3, {1.0, 0.0, 0.0}));
    const NodeRef normal = values.vector(call.geometry("normal", "Nworld"));
    return values.of_color(call.type,
                           call.nodes().vector_math(
                               "refract", {values.vector(from), normal, call.number("ior", 1.0)}));
}

/// A point, vector or normal in another space, which is the same one: an object stands where the
/// world has its origin.
Value transform(const NodeCall& call) {
    for (const char* space : {"fromspace", "tospace"})
        if (const std::string name = call.text(space);
            name != "" && name != "object" && name != "world" && name != "model")
            return call.refused("there is no space \"" + name + "\"");
    const double z = call.node.tag == "transformnormal" ? 1.0 : 0.0;
    return call.in("in", call.values().constant(Type::vector3, {0.0, 0.0, z}));
}

}  // namespace

Value turned(Arithmetic& values, const Value& value, NodeRef angle) {
    NodeBuilder& nodes = values.nodes;
    const NodeRef sine = nodes.math("sin", {angle}), cosine = nodes.math("cos", {angle});
    const NodeRef x = values.part(value, 0), y = values.part(value, 1);
    const auto product = [&](NodeRef a, NodeRef b) { return nodes.math("multiply", {a, b}); };
    return values.of_parts(Type::vector2,
                           {nodes.math("add", {product(cosine, x), product(sine, y)}),
                            nodes.math("subtract", {product(cosine, y), product(sine, x)})});
}

std::span<const NodeRow> vector_rows() {
    static constexpr std::array rows{
        NodeRow{"dotproduct", dotproduct},     NodeRow{"magnitude", magnitude},
        NodeRow{"distance", distance},         NodeRow{"normalize", normalize},
        NodeRow{"crossproduct", crossproduct}, NodeRow{"rotate2d", rotate2d},
        NodeRow{"rotate3d", rotate3d},         NodeRow{"reflect", reflect},
        NodeRow{"refract", refract},           NodeRow{"transformpoint", transform},
        NodeRow{"transformvector", transform}, NodeRow{"transformnormal", transform}};
    return rows;
}

}  // namespace burl::materialx
