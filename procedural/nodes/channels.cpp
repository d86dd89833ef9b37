// Colours by their channels: made of numbers, split into them, and corrected. Hue, saturation and
// value are those of the hexcone (Smith 1978, Color Gamut Transform Pairs). Light is linear; what
// is corrected is the straight colour, not the one multiplied by its alpha.
#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

Outputs combine(NodeOps& node) {
    const Register alpha = node.clamped(node.input(3));
    Outputs result;
    for (std::size_t c = 0; c < 3; ++c) result.push_back(node.multiply(alpha, node.input(c)));
    result.push_back(alpha);
    return result;
}

/// The luminance of linear light with the primaries of ITU-R BT.709.
Register luminance(NodeOps& node) {
    return node.apply(ValueOp::affine, {node.input(0, 0), node.input(0, 1), node.input(0, 2)},
                      {0.2126, 0.7152, 0.0722});
}

Outputs split(NodeOps& node) {
    const auto channel = std::size_t(node.parameter("channel"));
    const Register alpha = node.input(0, 3);
    if (channel == 3) return {alpha};
    return {node.ratio(channel < 3 ? node.input(0, channel) : luminance(node), alpha)};
}

/// The hue of a colour in sixths of a turn, in [-1, 5], given its channels, the largest of them and
/// the difference `chroma` between the largest and the smallest; 0 for greys. Which channel is the
/// largest says in which third of the hexagon the hue lies, the other two where.
Register hue(NodeOps& node, const std::array<Register, 3>& color, Register most, Register chroma) {
    const auto [red, green, blue] = color;
    const auto leads = [&](Register channel) {
        return node.apply(ValueOp::at_least, {node.combine(1.0, channel, -1.0, most)}, {0.0});
    };
    const auto third = [&](double begin, Register ahead, Register behind) {
        return node.combine(begin, chroma, 1.0, node.combine(1.0, ahead, -1.0, behind));
    };
    const Register other = node.lerp(leads(green), third(4.0, red, green), third(2.0, blue, red));
    return node.ratio(node.lerp(leads(red), other, third(0.0, green, blue)), chroma);
}

/// The share of chroma that a channel has at a hue in turns, `ahead` turns from where it is red's:
/// 1 for a third of a turn, 0 for another, linear between.
Register hexagon(NodeOps& node, Register hue, double ahead) {
    const Register turn = node.apply(ValueOp::fract, {node.linear(1.0, hue, ahead)});
    const Register away = node.apply(ValueOp::absolute, {node.linear(6.0, turn, -3.0)});
    return node.clamped(node.linear(1.0, away, -1.0));
}

/// The hexcone is as wide as it is high, so a colour multiplied by its alpha moves within it as the
/// straight colour does.
Outputs hsv(NodeOps& node) {
    const std::array color{node.input(0, 0), node.input(0, 1), node.input(0, 2)};
    const auto [red, green, blue] = color;
    const Register zero = node.constant(0.0);
    const Register most = node.maximum(red, node.maximum(green, blue)),
                   least = node.minimum(red, node.minimum(green, blue)),
                   chroma = node.combine(1.0, most, -1.0, least);
    const Register turned =
        node.combine(1.0 / 6.0, hue(node, color, most, chroma), 1.0, node.input(1));
    const Register more = node.multiply(node.maximum(zero, node.input(2)), chroma),
                   wide = node.minimum(node.maximum(most, chroma), more);
    const Register low = node.combine(1.0, most, -1.0, wide);
    const Register value = node.maximum(zero, node.input(3)), range = node.multiply(value, wide);
    Outputs result;
    for (const double ahead : {0.0, 2.0 / 3.0, 1.0 / 3.0})
        result.push_back(
            node.apply(ValueOp::products, {value, low, range, hexagon(node, turned, ahead)}));
    result.push_back(node.input(0, 3));
    return result;
}

/// The number x after the correction that the parameters of `levels` describe.
Register leveled(NodeOps& node, Register x) {
    x = node.clamped(node.share(x, node.parameter("in_black"), node.parameter("in_white")));
    const double gamma = node.parameter("gamma");
    if (gamma != 1.0) x = node.apply(ValueOp::power, {x}, {1.0 / gamma});
    const double black = node.parameter("out_black"), white = node.parameter("out_white");
    return node.linear(white - black, x, black);
}

Outputs levels(NodeOps& node) {
    if (node.channels() == 1) return {leveled(node, node.input(0))};
    const Register alpha = node.input(0, 3);
    Outputs result;
    for (std::size_t c = 0; c < 3; ++c)
        result.push_back(node.multiply(alpha, leveled(node, node.ratio(node.input(0, c), alpha))));
    result.push_back(alpha);
    return result;
}

constexpr std::string_view smith = "Smith 1978";

constexpr std::array channel_rows{
    a_node("combine", NodeResult::color, combine,
           "the colour of these channels, linear light, not yet multiplied by alpha", own,
           {a_number("red", "linear light", "0"), a_number("green", "linear light", "0"),
            a_number("blue", "linear light", "0"), a_number("alpha", "clamped to [0,1]", "1")}),
    a_node("split", NodeResult::number, split,
           "a channel of a colour, linear light, divided by alpha; 0 where alpha is 0", own,
           {a_color("input", "a colour")},
           {one_of("channel", "\"luminance\"", "red|green|blue|alpha|luminance",
                   "luminance is 0.2126 red + 0.7152 green + 0.0722 blue")}),
    a_node("hsv", NodeResult::color, hsv,
           "a colour, its hue turned, its saturation and value multiplied, in linear light", smith,
           {a_color("input", "a colour"), a_number("hue", "added to the hue, in turns", "0"),
            a_number("saturation", "factor, at least 0; saturation stays at most 1", "1"),
            a_number("value", "factor, at least 0", "1")}),
    a_node("levels", NodeResult::inputs, levels,
           "in_black to in_white taken to [0,1], clamped, to the power 1/gamma, taken to out_black "
           "to out_white; of red, green and blue, divided by alpha",
           own, {any("input", "a number, or a colour, which keeps its alpha")},
           {real("in_black", -1e6, 1e6, "0", "what becomes out_black"),
            real("in_white", -1e6, 1e6, "1", "what becomes out_white; at in_black: a step"),
            real("gamma", 0.1, 10, "1", "above 1: the middle becomes brighter"),
            real("out_black", -1e6, 1e6, "0", "what in_black becomes"),
            real("out_white", -1e6, 1e6, "1", "what in_white becomes")}),
};

}  // namespace

std::span<const NodeType> channels() {
    return channel_rows;
}

}  // namespace burl::nodes
