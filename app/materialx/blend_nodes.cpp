// One value over another.
#include <array>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {

/// Two layers and how much the upper one counts.
struct Layers {
    Value top, base, amount;
};

Layers layers_of(const NodeCall& call) {
    return {call.in("fg", 0.0), call.in("bg", 0.0), call.in("mix", Type::number, 1.0)};
}

Value compute(const NodeCall& call, const char* operation, const Value& a, const Value& b) {
    return call.values().apply(operation, call.type, {a, b});
}

/// The base as far as the amount goes towards what is laid over it.
Value laid_over(const NodeCall& call, const Layers& layers, const Value& covered) {
    return call.values().apply("mix", call.type, {layers.base, covered, layers.amount});
}

Value sum(const NodeCall& call) {
    const Layers layers = layers_of(call);
    return laid_over(call, layers, compute(call, "add", layers.base, layers.top));
}

Value difference(const NodeCall& call) {
    const Layers layers = layers_of(call);
    const Value rest = compute(call, "subtract", layers.base, layers.top);
    return laid_over(
        call, layers,
        call.node.tag == "minus" ? rest : call.values().apply("absval", call.type, {rest}));
}

Value screen(const NodeCall& call) {
    const Layers layers = layers_of(call);
    const Value one = call.values().filled(call.type, 1.0);
    const Value dark = compute(call, "multiply", compute(call, "subtract", one, layers.top),
                               compute(call, "subtract", one, layers.base));
    return laid_over(call, layers, compute(call, "subtract", one, dark));
}

/// The blends that a node of the recipe makes, channel by channel.
Value blended(const NodeCall& call) {
    const Layers layers = layers_of(call);
    return call.values().apply(call.node.tag, call.type, {layers.base, layers.top, layers.amount});
}

/// A layer times the alpha of another, or times what that leaves.
Value masked(const NodeCall& call, const Value& layer, const Value& by, bool rest) {
    Arithmetic& values = call.values();
    NodeRef alpha = values.part(by, 3);
    if (rest) alpha = call.nodes().math("subtract", {call.nodes().number(1.0), alpha});
    return compute(call, "multiply", layer, values.number(alpha));
}

Value composed(const NodeCall& call) {
    const Layers layers = layers_of(call);
    if (size_of(call.type) < 4) return call.refused("it is of colours with alpha");
    const std::string& tag = call.node.tag;
    Value covered = layers.base;
    if (tag == "in") covered = masked(call, layers.top, layers.base, false);
    if (tag == "out") covered = masked(call, layers.top, layers.base, true);
    if (tag == "mask") covered = masked(call, layers.base, layers.top, false);
    if (tag == "over")
        covered = compute(call, "add", layers.top, masked(call, layers.base, layers.top, true));
    return laid_over(call, layers, covered);
}

Value inside(const NodeCall& call) {
    NodeRef mask = call.number("mask", call.node.tag == "inside" ? 1.0 : 0.0);
    if (call.node.tag == "outside")
        mask = call.nodes().math("subtract", {call.nodes().number(1.0), mask});
    return compute(call, "multiply", call.in("in", 0.0), call.values().number(mask));
}

/// A colour times its own alpha, or divided by it.
Value premultiplied(const NodeCall& call) {
    const Value from = call.in("in", call.values().constant(Type::color4, {0.0, 0.0, 0.0, 1.0}));
    const Value alpha = call.values().number(call.values().part(from, 3));
    Value result = compute(call, call.node.tag == "premult" ? "multiply" : "divide", from, alpha);
    result.parts[3] = call.values().part(from, 3);
    return result;
}

}  // namespace

std::span<const NodeRow> blend_rows() {
    static constexpr std::array rows{NodeRow{"plus", sum},
                                     NodeRow{"minus", difference},
                                     NodeRow{"difference", difference},
                                     NodeRow{"screen", screen},
                                     NodeRow{"burn", blended},
                                     NodeRow{"dodge", blended},
                                     NodeRow{"overlay", blended},
                                     NodeRow{"in", composed},
                                     NodeRow{"out", composed},
                                     NodeRow{"mask", composed},
                                     NodeRow{"over", composed},
                                     NodeRow{"inside", inside},
                                     NodeRow{"outside", inside},
                                     NodeRow{"premult", premultiplied},
                                     NodeRow{"unpremult", premultiplied}};
    return rows;
}

}  // namespace burl::materialx
