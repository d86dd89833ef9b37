// Corrections of colours.
#include <array>

#include "app/materialx/nodes.h"
#include "app/materialx/values/convert.h"

namespace burl::materialx {

namespace {

/// The colour of a vector operation on the input's first three components; its fourth stays.
Value with_color(const NodeCall& call, const Value& from, NodeRef color) {
    if (size_of(call.type) < 4) return call.values().of_color(call.type, color);
    return call.values().of_color(call.type, color, call.values().part(from, 3));
}

/// The luminance of a colour by the node's own weights.
NodeRef luminance_of(const NodeCall& call, const Value& color) {
    const Value weights = call.in(
        "lumacoeffs", call.values().constant(Type::color3, {0.2722287, 0.6740818, 0.0536895}));
    return call.nodes().vector_math("luminance",
                                    {call.values().packed(color), call.values().packed(weights)});
}

Value luminance(const NodeCall& call) {
    const Value from = call.in("in", 0.0);
    return with_color(call, from, luminance_of(call, from));
}

Value hsv_change(const NodeCall& call) {
    const Value from = call.in("in", 0.0);
    return with_color(call, from,
                      call.nodes().vector_math(call.node.tag, {call.values().packed(from)}));
}

/// The colour with its hue moved, its saturation and value multiplied.
NodeRef adjusted(NodeBuilder& nodes, NodeRef color, const std::vector<NodeRef>& amount) {
    const NodeRef zero = nodes.number(0.0), one = nodes.number(1.0);
    const NodeRef hsv = nodes.vector_math("rgbtohsv", {color});
    const NodeRef turned_hue =
        nodes.vector_math("add", {hsv, nodes.combined({amount[0], zero, zero})});
    const NodeRef changed =
        nodes.vector_math("multiply", {turned_hue, nodes.combined({one, amount[1], amount[2]})});
    return nodes.vector_math("hsvtorgb", {changed});
}

Value hsv_adjust(const NodeCall& call) {
    const Value from = call.in("in", 0.0);
    const Value amount = call.in("amount", call.values().constant(Type::vector3, {0.0, 1.0, 1.0}));
    return with_color(
        call, from,
        adjusted(call.nodes(), call.values().packed(from), call.values().parts_of(amount)));
}

NodeRef saturated(const NodeCall& call, NodeRef color, NodeRef grey, NodeRef amount) {
    return call.values().packed(call.values().apply(
        "mix", Type::color3,
        {call.values().of_color(Type::color3, grey), call.values().of_color(Type::color3, color),
         call.values().number(amount)}));
}

Value saturate(const NodeCall& call) {
    const Value from = call.in("in", 0.0);
    return with_color(call, from,
                      saturated(call, call.values().packed(from), luminance_of(call, from),
                                call.number("amount", 1.0)));
}

/// One step of a correction: an operation on all channels with a number.
class Correction {
  public:
    Correction(const NodeCall& call, NodeRef color) : call_(call), color_(color) {}

    void with(const char* operation, NodeRef number) {
        color_ = call_.values().packed(call_.values().apply(
            operation, Type::color3, {color(), call_.values().number(number)}));
    }
    void to_power(NodeRef exponent) {
        Arithmetic& values = call_.values();
        if (call_.nodes().constant(exponent) == 1.0) return;
        const Value sign = values.apply("sign", Type::color3, {color()});
        const Value size = values.apply("absval", Type::color3, {color()});
        const Value power = values.apply("power", Type::color3, {size, values.number(exponent)});
        color_ = values.packed(values.apply("multiply", Type::color3, {power, sign}));
    }
    NodeRef result() const { return color_; }

  private:
    Value color() const { return call_.values().of_color(Type::color3, color_); }

    const NodeCall& call_;
    NodeRef color_;
};

/// The colour with hue, saturation and gamma corrected, the first half of `colorcorrect`.
NodeRef hue_corrected(const NodeCall& call, NodeRef color) {
    NodeBuilder& nodes = call.nodes();
    const NodeRef one = nodes.number(1.0), hue = call.number("hue", 0.0);
    if (nodes.constant(hue) != 0.0) color = adjusted(nodes, color, {hue, one, one});
    const NodeRef amount = call.number("saturation", 1.0);
    if (nodes.constant(amount) == 1.0) return color;
    return saturated(call, color, luminance_of(call, call.values().of_color(Type::color3, color)),
                     amount);
}

Value color_correct(const NodeCall& call) {
    NodeBuilder& nodes = call.nodes();
    const Value from = call.in("in", call.values().filled(call.type, 1.0));
    Correction steps(call, hue_corrected(call, call.values().packed(from)));
    const NodeRef one = nodes.number(1.0), lift = call.number("lift", 0.0);
    const NodeRef pivot = call.number("contrastpivot", 0.5);
    steps.to_power(nodes.math("divide", {one, call.number("gamma", 1.0)}));
    steps.with("multiply", nodes.math("subtract", {one, lift}));
    steps.with("add", lift);
    steps.with("multiply", call.number("gain", 1.0));
    steps.with("subtract", pivot);
    steps.with("multiply", call.number("contrast", 1.0));
    steps.with("add", pivot);
    steps.with("multiply", nodes.math("power", {nodes.number(2.0), call.number("exposure", 0.0)}));
    return with_color(call, from, steps.result());
}

}  // namespace

std::span<const NodeRow> color_rows() {
    static constexpr std::array rows{
        NodeRow{"luminance", luminance}, NodeRow{"rgbtohsv", hsv_change},
        NodeRow{"hsvtorgb", hsv_change}, NodeRow{"hsvadjust", hsv_adjust},
        NodeRow{"saturate", saturate},   NodeRow{"colorcorrect", color_correct}};
    return rows;
}

}  // namespace burl::materialx
