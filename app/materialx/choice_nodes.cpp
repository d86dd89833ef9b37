// Nodes that choose among values, and truth.
#include <array>

#include <fmt/format.h>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {

/// The inputs that a `switch` may have.
constexpr int most_choices = 10;

Value chosen(const NodeCall& call, NodeRef condition, const Value& yes, const Value& no) {
    return call.values().apply("mix", call.type, {no, yes, call.values().number(condition)});
}

Value compared(const NodeCall& call) {
    const double left_out = call.node.tag == "ifequal" ? 0.0 : 1.0;
    const NodeRef condition = call.nodes().math(
        call.node.tag, {call.number("value1", left_out), call.number("value2", 0.0)});
    if (call.type == Type::boolean) return call.made(condition);
    return chosen(call, condition, call.in("in1", 0.0), call.in("in2", 0.0));
}

/// The first input for a `which` below 1, the second below 2, and so on.
Value switched(const NodeCall& call) {
    const NodeRef which = call.number("which", 0.0);
    const auto known = call.nodes().constant(which);
    Value result = call.values().filled(call.type, 0.0);
    for (int k = most_choices; k >= 1; --k) {
        const std::string name = fmt::format("in{}", k);
        if (known && !(*known < k)) break;
        if (known && k > 1 && *known < k - 1) continue;
        const Value one = call.in(name, 0.0);
        if (known) return one;
        const NodeRef condition = call.nodes().math("ifgreater", {call.nodes().number(k), which});
        result = chosen(call, condition, one, result);
    }
    return result;
}

Value both(const NodeCall& call) {
    return call.values().apply("min", call.type, {call.in("in1", 0.0), call.in("in2", 0.0)});
}
Value either(const NodeCall& call) {
    return call.values().apply("max", call.type, {call.in("in1", 0.0), call.in("in2", 0.0)});
}
Value one_of_two(const NodeCall& call) {
    const Value difference =
        call.values().apply("subtract", call.type, {call.in("in1", 0.0), call.in("in2", 0.0)});
    return call.values().apply("absval", call.type, {difference});
}
Value negated(const NodeCall& call) {
    return call.values().apply("subtract", call.type,
                               {call.values().filled(call.type, 1.0), call.in("in", 0.0)});
}

}  // namespace

std::span<const NodeRow> choice_rows() {
    static constexpr std::array rows{
        NodeRow{"ifgreater", compared}, NodeRow{"ifgreatereq", compared},
        NodeRow{"ifequal", compared},   NodeRow{"switch", switched},
        NodeRow{"and", both},           NodeRow{"or", either},
        NodeRow{"xor", one_of_two},     NodeRow{"not", negated}};
    return rows;
}

}  // namespace burl::materialx
