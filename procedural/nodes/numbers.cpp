// Numbers and arithmetic; the weighted sums of pbrt's scale, mix and bilerp textures, which leave
// filtering to their inputs.
#include "procedural/color/srgb.h"
#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

/// The definition of a node that is an operation on its inputs.
template <ValueOp op>
Outputs of_inputs(NodeOps& node) {
    std::vector<Register> inputs;
    for (std::size_t k = 0; k < node.self().inputs.size(); ++k) inputs.push_back(node.input(k));
    return {node.apply(op, std::move(inputs))};
}

Outputs constant(NodeOps& node) {
    const std::vector<double>& p = node.self().parameters;
    if (node.channels() == 1) return {node.constant(p[0])};
    const double alpha = p[3] / 255.0;
    Outputs result;
    for (std::size_t c = 0; c < 3; ++c)
        result.push_back(node.constant(alpha * srgb_decode(p[c] / 255.0)));
    result.push_back(node.constant(alpha));
    return result;
}

Outputs coordinate(NodeOps& node) {
    return {node.along(node.vector("direction"), node.parameter("offset"))};
}

Outputs subtract(NodeOps& node) {
    return {node.combine(1.0, node.input(0), -1.0, node.input(1))};
}

/// The ratio of numbers of any sign: of a / b and -a / b, each 0 where its divisor is not above 0,
/// one at most is not 0.
Outputs divide(NodeOps& node) {
    const Register a = node.input(0), b = node.input(1);
    const Register above = node.ratio(a, b), below = node.ratio(a, node.linear(-1.0, b));
    return {node.combine(1.0, above, -1.0, below)};
}

Outputs clamp(NodeOps& node) {
    return {node.clamped(node.input(0), node.parameter("low"), node.parameter("high"))};
}

Outputs remap(NodeOps& node) {
    Register share = node.share(node.input(0), node.parameter("in_low"), node.parameter("in_high"));
    if (node.parameter("clamp") == 0.0) share = node.clamped(share);
    const double low = node.parameter("out_low"), high = node.parameter("out_high");
    return {node.linear(high - low, share, low)};
}

Outputs length(NodeOps& node) {
    return {node.length(node.length(node.input(0), node.input(1)), node.input(2))};
}

Outputs distance(NodeOps& node) {
    const Vec3d from = node.vector("point"), weights = node.vector("weights");
    std::array<Register, 3> away{};
    for (int i = 0; i < 3; ++i) {
        Vec3d along(0.0);
        along[i] = weights[i];
        away[std::size_t(i)] = node.along(along, -weights[i] * from[i]);
    }
    return {node.length(node.length(away[0], away[1]), away[2])};
}

Outputs dot(NodeOps& node) {
    const Vec3d d = node.vector("direction");
    return {node.apply(ValueOp::affine, {node.input(0), node.input(1), node.input(2)},
                       {d.x, d.y, d.z})};
}

Outputs power_of(NodeOps& node) {
    return {node.apply(ValueOp::power, {node.input(0)}, {node.parameter("exponent")})};
}

Outputs slope_of(NodeOps& node) {
    return {node.apply(SlopeAlong{node.vector("direction")}, {node.input(0)})};
}

Outputs smoothstep(NodeOps& node) {
    return {node.apply(ValueOp::smoothstep, {node.input(0)},
                       {node.parameter("low"), node.parameter("high")})};
}

Outputs scale(NodeOps& node) {
    Outputs result;
    for (std::size_t c = 0; c < node.channels(); ++c)
        result.push_back(node.multiply(node.input(0, c), node.input(1, c)));
    return result;
}

Outputs mix(NodeOps& node) {
    return node.blend(node.input(2));
}

Outputs bilerp(NodeOps& node) {
    const Register u = node.axis(0), v = node.axis(1);
    Outputs result;
    for (std::size_t c = 0; c < node.channels(); ++c)
        result.push_back(node.lerp(u, node.lerp(v, node.input(0, c), node.input(1, c)),
                                   node.lerp(v, node.input(2, c), node.input(3, c))));
    return result;
}

constexpr Inputs two_numbers{a_number("a", "a number"), a_number("b", "a number")};
constexpr Inputs triple{a_number("x", "the first number", "0"),
                        a_number("y", "the second number", "0"),
                        a_number("z", "the third number", "0")};

constexpr std::array number_rows{
    a_node("constant", NodeResult::inputs, constant,
           "a number or an sRGB colour, `value`; also written as the bare value", pbrt),
    a_node("coordinate", NodeResult::number, coordinate, "direction . point + offset", own, {},
           {several("direction", 3, "[1,0,0]", "weights of the point's coordinates"),
            real("offset", -1e6, 1e6, "0", "added")}),
    a_node("add", NodeResult::number, of_inputs<ValueOp::add>, "a + b", own, two_numbers),
    a_node("subtract", NodeResult::number, subtract, "a - b", own, two_numbers),
    a_node("multiply", NodeResult::number, of_inputs<ValueOp::multiply>, "a b", own, two_numbers),
    a_node("divide", NodeResult::number, divide, "a / b, and 0 where b is 0", own,
           {a_number("a", "the dividend"), a_number("b", "the divisor")}),
    a_node("min", NodeResult::number, of_inputs<ValueOp::minimum>, "the smaller of a and b", own,
           two_numbers),
    a_node("max", NodeResult::number, of_inputs<ValueOp::maximum>, "the larger of a and b", own,
           two_numbers),
    a_node("clamp", NodeResult::number, clamp, "input, at least low and at most high", own,
           one_number,
           {real("low", -1e6, 1e6, "0", "the least it gives"),
            real("high", -1e6, 1e6, "1", "the most it gives; all that it gives if below low")}),
    a_node("remap", NodeResult::number, remap,
           "input taken linearly from [in_low, in_high] to [out_low, out_high]", own, one_number,
           {real("in_low", -1e6, 1e6, "0", "what becomes out_low"),
            real("in_high", -1e6, 1e6, "1", "what becomes out_high; at in_low: a step"),
            real("out_low", -1e6, 1e6, "0", "what in_low becomes"),
            real("out_high", -1e6, 1e6, "1", "what in_high becomes"),
            one_of("clamp", "\"on\"", "on|off", "whether it keeps to the range of results")}),
    a_node("abs", NodeResult::number, of_inputs<ValueOp::absolute>, "the absolute value of input",
           own, one_number),
    a_node("power", NodeResult::number, power_of,
           "input^exponent; a negative input counts as 0 unless the exponent is whole", own,
           one_number, {real("exponent", 0, 64, "2", "the exponent")}),
    a_node("sin", NodeResult::number, of_inputs<ValueOp::sine>, "sin(input), in radians", own,
           one_number),
    a_node("slope", NodeResult::number, slope_of,
           "direction . gradient of input with respect to the solid point; its own is given as 0",
           "DNoise of Perlin 1985", one_number,
           {several("direction", 3, "[1,0,0]", "along which input's growth is taken")}),
    a_node("floor", NodeResult::number, of_inputs<ValueOp::floor>,
           "the largest whole number not above input", own, one_number),
    a_node("fract", NodeResult::number, of_inputs<ValueOp::fract>, "input - floor(input)", slides,
           one_number),
    a_node("smoothstep", NodeResult::number, smoothstep,
           "0 up to low, 1 from high on, 3u^2 - 2u^3 between", own, one_number,
           {real("low", -1e6, 1e6, "0", "where it leaves 0"),
            real("high", -1e6, 1e6, "1", "where it reaches 1; at or below low: a step")}),
    a_node("length", NodeResult::number, length, "sqrt(x^2 + y^2 + z^2)", own, triple),
    a_node("distance", NodeResult::number, distance,
           "the length of weights (p - point) of the point p where it is evaluated", own, {},
           {several("point", 3, "[0,0,0]", "from where it is measured"),
            several("weights", 3, "[1,1,1]", "factors by axis; 0 leaves an axis out")}),
    a_node("dot", NodeResult::number, dot, "direction . (x, y, z)", own, triple,
           {several("direction", 3, "[0,0,1]", "weights of x, y and z")}),
    a_node("scale", NodeResult::inputs, scale, "a b, channel by channel", pbrt,
           {any("a", "a factor"), any("b", "a factor")}),
    a_node("mix", NodeResult::inputs, mix, "(1 - amount) a + amount b", pbrt,
           {any("a", "at amount 0", "0"), any("b", "at amount 1", "1"),
            a_number("amount", "weight of b", "0.5")}),
    a_node("bilerp", NodeResult::inputs, bilerp,
           "four values interpolated by the point's first two coordinates, u and v", pbrt,
           {any("v00", "at u = 0, v = 0", "0"), any("v01", "at u = 0, v = 1", "1"),
            any("v10", "at u = 1, v = 0", "0"), any("v11", "at u = 1, v = 1", "1")}),
};

}  // namespace

std::span<const NodeType> numbers() {
    return number_rows;
}

}  // namespace burl::nodes
