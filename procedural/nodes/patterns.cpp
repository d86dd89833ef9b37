// The regular patterns of Chuang's slides on pbrt's textures (2008): all are jumps of something
// smooth, whose means over a footprint are exact.
#include <numbers>

#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

Register mean_of(NodeOps& node, ValueOp function, Register x) {
    return node.apply(BoxMean{function}, {x});
}

Outputs uv(NodeOps& node) {
    const Register u = mean_of(node, ValueOp::fract, node.axis(0)),
                   v = mean_of(node, ValueOp::fract, node.axis(1));
    return {u, v, node.constant(0.0), node.constant(1.0)};
}

template <std::size_t axes>
Outputs board(NodeOps& node) {
    const Checkerboard cells{Antialiasing(int(node.parameter("aa"))), axes};
    return node.blend(node.apply(cells, node.point()));
}

/// The coordinate along `direction`, in periods.
Register periods(NodeOps& node) {
    return node.along(node.vector("direction") / node.parameter("period"));
}

Outputs stripes(NodeOps& node) {
    return node.blend(mean_of(node, ValueOp::odd, periods(node)));
}

Outputs ramp(NodeOps& node) {
    return node.blend(mean_of(node, ValueOp::fract, periods(node)));
}

Outputs sine_wave(NodeOps& node) {
    const Register angle = node.linear(2.0 * std::numbers::pi, periods(node));
    return node.blend(node.linear(0.5, mean_of(node, ValueOp::sine, angle), 0.5));
}

Outputs rings(NodeOps& node) {
    const Register away = node.length(node.axis(0), node.axis(1));
    return node.blend(
        mean_of(node, ValueOp::odd, node.linear(1.0 / node.parameter("spacing"), away)));
}

Outputs wood_grain(NodeOps& node) {
    const Register angle = node.angle(node.axis(1), node.axis(0));
    const Register turned =
        node.combine(node.parameter("wobbles"), angle, node.parameter("twist"), node.axis(2));
    const Register away = node.length(node.axis(0), node.axis(1));
    const Register x = node.combine(1.0 / node.parameter("spacing"), away, node.parameter("wobble"),
                                    node.sine(turned));
    const bool ramped = node.parameter("profile") == 1.0;
    return node.blend(mean_of(node, ramped ? ValueOp::fract : ValueOp::odd, x));
}

constexpr Parameters checker_parameters{
    one_of("aa", "\"closed_form\"", "none|closed_form|supersample|trapezoid",
           "none, pbrt's share of b in a box, its 4 x 4 stratified samples, or the share over the "
           "texel's two sides")};
constexpr Parameters along_parameters{
    several("direction", 3, "[1,0,0]", "the point's component along it counts"),
    real("period", 1e-6, 1e6, "1", "length after which a cell ends")};

constexpr std::array pattern_rows{
    a_node("uv", NodeResult::color, uv,
           "red and green are the fractions of the point's first two coordinates", pbrt),
    a_node("checkerboard", NodeResult::inputs, board<2>,
           "unit squares in the point's first two coordinates", pbrt, two_sides,
           checker_parameters),
    a_node("checkerboard_3d", NodeResult::inputs, board<3>, "unit cubes", pbrt, two_sides,
           checker_parameters),
    a_node("stripes", NodeResult::inputs, stripes, "slabs one period thick, across a direction",
           slides, two_sides, along_parameters),
    a_node("ramp", NodeResult::inputs, ramp, "from a to b over each period: mod(x, p) / p", slides,
           two_sides, along_parameters),
    a_node("sine", NodeResult::inputs, sine_wave,
           "between a and b as (sin(2 pi x / period) + 1) / 2", slides, two_sides,
           along_parameters),
    a_node("rings", NodeResult::inputs, rings, "tubes round the r axis", slides, two_sides,
           {real("spacing", 1e-6, 1e6, "1", "thickness of a ring")}),
    a_node("wood_grain", NodeResult::inputs, wood_grain,
           "rings of distance / spacing + wobble sin(wobbles angle + twist r)", slides, two_sides,
           {real("spacing", 1e-6, 1e6, "1", "thickness of a ring"),
            real("wobble", 0, 1e3, "0.2", "how far a ring strays, in rings"),
            whole("wobbles", 0, 1000, "5", "how often in one turn"),
            real("twist", -1e6, 1e6, "0", "radians by which the wobble turns per unit of r"),
            one_of("profile", "\"hard\"", "hard|ramp",
                   "rings change from a to b, or rise from a to b and fall back")}),
};

}  // namespace

std::span<const NodeType> patterns() {
    return pattern_rows;
}

}  // namespace burl::nodes
