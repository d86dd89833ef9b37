// Arithmetic, component by component.
#include <array>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {

/// An operation of two values, of which the second counts as 0 where it is left out.
Value of_two(const NodeCall& call) {
    return call.values().apply(call.node.tag, call.type,
                               {call.in("in1", 0.0), call.in("in2", 0.0)});
}

/// Applies an operation that a second value of 1 leaves alone; that is the default.
Value by_one(const NodeCall& call) {
    return call.values().apply(call.node.tag, call.type,
                               {call.in("in1", 0.0), call.in("in2", 1.0)});
}

Value of_one(const NodeCall& call) {
    return call.values().apply(call.node.tag, call.type, {call.in("in", 0.0)});
}

Value logarithm(const NodeCall& call) {
    return call.values().apply("ln", call.type, {call.in("in", 1.0)});
}

/// MaterialX 1.38 calls the inputs in1 and in2.
Value arc_tangent(const NodeCall& call) {
    const double y = is_number(call.type) ? 0.0 : 1.0;
    return call.values().apply(
        "atan2", call.type,
        {call.in("iny", call.in("in1", y)), call.in("inx", call.in("in2", 1.0 - y))});
}

Value inverted(const NodeCall& call) {
    return call.values().apply("subtract", call.type, {call.in("amount", 1.0), call.in("in", 0.0)});
}

Value clamped(const NodeCall& call) {
    return call.values().apply("clamp", call.type,
                               {call.in("in", 0.0), call.in("low", 0.0), call.in("high", 1.0)});
}

Value smooth_step(const NodeCall& call) {
    return call.values().apply("smoothstep", call.type,
                               {call.in("in", 0.0), call.in("low", 0.0), call.in("high", 1.0)});
}

Value mixed(const NodeCall& call) {
    return call.values().apply("mix", call.type,
                               {call.in("bg", 0.0), call.in("fg", 0.0), call.in("mix", 0.0)});
}

/// A range of values, from `low` to `high`.
struct Range {
    Value low, high;
};

Range range_of(const NodeCall& call, const char* low, const char* high) {
    return {call.in(low, 0.0), call.in(high, 1.0)};
}

Value remapped(const NodeCall& call, const Value& value, const Range& from, const Range& to) {
    const auto compute = [&](const char* operation, const Value& a, const Value& b) {
        return call.values().apply(operation, call.type, {a, b});
    };
    const Value rise = compute("multiply", compute("subtract", value, from.low),
                               compute("subtract", to.high, to.low));
    return compute("add", to.low,
                   compute("divide", rise, compute("subtract", from.high, from.low)));
}

Value remap(const NodeCall& call) {
    return remapped(call, call.in("in", 0.0), range_of(call, "inlow", "inhigh"),
                    range_of(call, "outlow", "outhigh"));
}

/// The value to the power 1 / gamma, with its sign.
Value with_gamma(const NodeCall& call, const Value& value, const Value& gamma) {
    const auto compute = [&](const char* operation, const std::vector<Value>& inputs) {
        return call.values().apply(operation, call.type, inputs);
    };
    const auto constants = call.values().constants_of(gamma);
    if (constants == std::vector<double>(size_of(gamma.type), 1.0)) return value;
    const Value exponent = compute("divide", {call.values().filled(call.type, 1.0), gamma});
    return compute("multiply", {compute("power", {compute("absval", {value}), exponent}),
                                compute("sign", {value})});
}

Value range(const NodeCall& call) {
    Arithmetic& values = call.values();
    const Range unit{values.filled(call.type, 0.0), values.filled(call.type, 1.0)};
    const Range to = range_of(call, "outlow", "outhigh");
    const Value inner = remapped(call, call.in("in", 0.0), range_of(call, "inlow", "inhigh"), unit);
    const Value result = remapped(call, with_gamma(call, inner, call.in("gamma", 1.0)), unit, to);
    const auto clamps = call.constant("doclamp", 0.0);
    if (!clamps) return call.varies("doclamp");
    if (*clamps == 0.0) return result;
    return values.apply("clamp", call.type, {result, to.low, to.high});
}

Value contrast(const NodeCall& call) {
    const Value pivot = call.in("pivot", 0.5);
    const auto compute = [&](const char* operation, const Value& a, const Value& b) {
        return call.values().apply(operation, call.type, {a, b});
    };
    return compute(
        "add",
        compute("multiply", compute("subtract", call.in("in", 0.0), pivot), call.in("amount", 1.0)),
        pivot);
}

}  // namespace

std::span<const NodeRow> math_rows() {
    static constexpr std::array rows{
        NodeRow{"add", of_two},          NodeRow{"subtract", of_two},
        NodeRow{"multiply", by_one},     NodeRow{"divide", by_one},
        NodeRow{"modulo", by_one},       NodeRow{"power", by_one},
        NodeRow{"safepower", by_one},    NodeRow{"min", of_two},
        NodeRow{"max", of_two},          NodeRow{"absval", of_one},
        NodeRow{"sign", of_one},         NodeRow{"floor", of_one},
        NodeRow{"ceil", of_one},         NodeRow{"round", of_one},
        NodeRow{"fract", of_one},        NodeRow{"sin", of_one},
        NodeRow{"cos", of_one},          NodeRow{"tan", of_one},
        NodeRow{"asin", of_one},         NodeRow{"acos", of_one},
        NodeRow{"sqrt", of_one},         NodeRow{"exp", of_one},
        NodeRow{"trianglewave", of_one}, NodeRow{"ln", logarithm},
        NodeRow{"atan2", arc_tangent},   NodeRow{"invert", inverted},
        NodeRow{"clamp", clamped},       NodeRow{"smoothstep", smooth_step},
        NodeRow{"mix", mixed},           NodeRow{"remap", remap},
        NodeRow{"range", range},         NodeRow{"contrast", contrast}};
    return rows;
}

}  // namespace burl::materialx
