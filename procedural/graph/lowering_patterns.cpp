// Numbers, patterns, colours and mappings as operations; math.cpp, patterns.cpp, colors.cpp and
// mappings.cpp have the same nodes with gradients. There is no footprint, so every pattern is its
// own function.
#include <numbers>

#include "procedural/color/srgb.h"
#include "procedural/color/table.h"
#include "procedural/graph/affine.h"
#include "procedural/graph/lowering.h"

namespace burl {

namespace {

using std::numbers::pi;

template <ValueOp op>
LoweredNode of_one(const LoweringCall& call) {
    return call.number(call.program->add(op, {call.input(0)}));
}

template <ValueOp op>
LoweredNode of_two(const LoweringCall& call) {
    return call.number(call.program->add(op, {call.input(0), call.input(1)}));
}

LoweredNode constant(const LoweringCall& call) {
    const std::vector<double>& p = call.node->parameters;
    if (!call.is_color()) return call.number(call.program->constant(p[0]));
    const double alpha = p[3] / 255.0;
    LoweredNode result;
    for (std::size_t c = 0; c < 3; ++c)
        result.channels.push_back(call.program->constant(alpha * srgb_decode(p[c] / 255.0)));
    result.channels.push_back(call.program->constant(alpha));
    return result;
}

LoweredNode coordinate(const LoweringCall& call) {
    return call.number(call.along(call.vector("direction"), call.parameter("offset")));
}

LoweredNode add(const LoweringCall& call) {
    return call.number(call.add(call.input(0), call.input(1)));
}

LoweredNode multiply(const LoweringCall& call) {
    return call.number(call.multiply(call.input(0), call.input(1)));
}

LoweredNode power(const LoweringCall& call) {
    return call.number(
        call.program->add(ValueOp::power, {call.input(0)}, {call.parameter("exponent")}));
}

/// The only node that needs a gradient: its input is evaluated by a GraphEvaluator.
LoweredNode slope(const LoweringCall& call) {
    TextureGraph input = *call.graph;
    input.nodes.resize(call.node->inputs[0] + 1);
    return call.number(call.program
                           ->add(GraphSlope{std::make_shared<GraphEvaluator>(
                                                input, Filter{}, PrecisionKind::float32),
                                            call.vector("direction")},
                                 {0, 1, 2})
                           .front());
}

LoweredNode smoothstep(const LoweringCall& call) {
    return call.number(call.program->add(ValueOp::smoothstep, {call.input(0)},
                                         {call.parameter("low"), call.parameter("high")}));
}

LoweredNode scale(const LoweringCall& call) {
    LoweredNode result;
    for (std::size_t c = 0; c < std::size_t(call.node->wire); ++c)
        result.channels.push_back(call.multiply(call.input(0, c), call.input(1, c)));
    return result;
}

LoweredNode mix(const LoweringCall& call) {
    return call.blend(call.input(2));
}

LoweredNode bilerp(const LoweringCall& call) {
    const Register u = call.axis(0), v = call.axis(1);
    LoweredNode result;
    for (std::size_t c = 0; c < std::size_t(call.node->wire); ++c)
        result.channels.push_back(call.lerp(u, call.lerp(v, call.input(0, c), call.input(1, c)),
                                            call.lerp(v, call.input(2, c), call.input(3, c))));
    return result;
}

/// A colour map as linear pieces.
ColorPieces pieces_of(const ColorMap& colors) {
    const PreparedColorMap map(colors);
    ColorPieces pieces;
    if (map.wrap() == Wrap::repeat) pieces.argument = ColorPieces::Argument::repeat;
    for (std::size_t i = 0; i < map.segments(); ++i) {
        const double begin = map.begin(i);
        const Vec3d color = map.color(i, begin), next = map.color(i, begin + 1.0);
        pieces.begins.push_back(begin);
        pieces.table.push_back(begin);
        for (int c = 0; c < 3; ++c)
            pieces.table.insert(pieces.table.end(), {color[c], next[c] - color[c]});
    }
    return pieces;
}

LoweredNode color_map(const LoweringCall& call) {
    const ColorMap& colors = call.graph->textures[call.node->texture].colors;
    LoweredNode result{call.program->add(pieces_of(colors), {call.input(0)}, 3), {}};
    result.channels.push_back(call.program->constant(1.0));
    return result;
}

LoweredNode layer_over(const LoweringCall& call) {
    ValueProgram& program = *call.program;
    const Register zero = program.constant(0.0), one = program.constant(1.0);
    const Register opacity =
        program.add(ValueOp::minimum, {one, program.add(ValueOp::maximum, {zero, call.input(2)})});
    const Register shows = call.linear(-1.0, call.multiply(opacity, call.input(0, 3)), 1.0);
    LoweredNode result;
    for (std::size_t c = 0; c < 4; ++c)
        result.channels.push_back(
            program.add(ValueOp::products, {opacity, call.input(0, c), shows, call.input(1, c)}));
    return result;
}

LoweredNode image(const LoweringCall& call) {
    const ImageLookup lookup{call.graph->images[call.node->image].pixels,
                             ImageWrap(int(call.parameter("wrap")))};
    LoweredNode result{call.program->add(lookup, {call.axis(0), call.axis(1)}, 3), {}};
    result.channels.push_back(call.program->constant(1.0));
    return result;
}

LoweredNode uv(const LoweringCall& call) {
    const auto fract = [&](int i) { return call.program->add(ValueOp::fract, {call.axis(i)}); };
    return {{fract(0), fract(1), call.program->constant(0.0), call.program->constant(1.0)}, {}};
}

/// The checkerboard of the first `axes` coordinates, 1 in its odd cells: 1/2 - 1/2 prod (1 - 2
/// odd).
LoweredNode checkers(const LoweringCall& call, int axes) {
    Register sign = call.program->constant(1.0);
    for (int i = 0; i < axes; ++i) {
        const Register odd = call.program->add(ValueOp::odd, {call.axis(i)});
        sign = call.multiply(sign, call.linear(-2.0, odd, 1.0));
    }
    return call.blend(call.linear(-0.5, sign, 0.5));
}

LoweredNode checkerboard(const LoweringCall& call) {
    return checkers(call, 2);
}

LoweredNode checkerboard_3d(const LoweringCall& call) {
    return checkers(call, 3);
}

/// The coordinate along `direction`, in periods.
Register periods(const LoweringCall& call) {
    return call.along(call.vector("direction") / call.parameter("period"));
}

LoweredNode stripes(const LoweringCall& call) {
    return call.blend(call.program->add(ValueOp::odd, {periods(call)}));
}

LoweredNode ramp(const LoweringCall& call) {
    return call.blend(call.program->add(ValueOp::fract, {periods(call)}));
}

LoweredNode sine(const LoweringCall& call) {
    const Register angle = call.linear(2.0 * pi, periods(call));
    return call.blend(call.linear(0.5, call.program->add(ValueOp::sine, {angle}), 0.5));
}

/// The distance of the point from the r axis.
Register off_axis(const LoweringCall& call) {
    return call.program->add(ValueOp::length, {call.axis(0), call.axis(1)});
}

/// The angle of the point about the r axis.
Register angle(const LoweringCall& call) {
    return call.program->add(ValueOp::angle, {call.axis(1), call.axis(0)});
}

LoweredNode rings(const LoweringCall& call) {
    const Register x = call.linear(1.0 / call.parameter("spacing"), off_axis(call));
    return call.blend(call.program->add(ValueOp::odd, {x}));
}

LoweredNode wood_grain(const LoweringCall& call) {
    ValueProgram& program = *call.program;
    const Register turned = program.add(ValueOp::combine, {angle(call), call.axis(2)},
                                        {call.parameter("wobbles"), call.parameter("twist"), 0.0});
    const Register x =
        program.add(ValueOp::combine, {off_axis(call), program.add(ValueOp::sine, {turned})},
                    {1.0 / call.parameter("spacing"), call.parameter("wobble"), 0.0});
    const bool ramped = call.parameter("profile") == 1.0;
    return call.blend(program.add(ramped ? ValueOp::fract : ValueOp::odd, {x}));
}

/// A node whose result is the place moved by `map`.
LoweredNode moved(const LoweringCall& call, const Affine3& map) {
    return {{}, {call.place.base, map.after(call.place.map)}};
}

LoweredNode transform(const LoweringCall& call) {
    NodeCall node;
    node.node = call.node;
    return moved(call, transform_map(node));
}

LoweredNode map_uv(const LoweringCall& call) {
    Affine3 map{Mat3d(1.0), {call.parameter("offset", 0), call.parameter("offset", 1), 0.0}};
    for (int i = 0; i < 2; ++i) map.linear[i][i] = call.parameter("scale", std::size_t(i));
    return moved(call, map);
}

LoweredNode map_planar(const LoweringCall& call) {
    const Mat3d rows(call.vector("vs"), call.vector("vt"), Vec3d(0.0));
    return moved(call, {glm::transpose(rows),
                        {call.parameter("offset", 0), call.parameter("offset", 1), 0.0}});
}

LoweredNode map_spherical(const LoweringCall& call) {
    ValueProgram& program = *call.program;
    const Register away = off_axis(call), z = call.axis(2);
    const Register turn = call.linear(0.5 / pi, angle(call));
    const Register positive = program.add(ValueOp::at_least, {turn}, {0.0});
    const Register down = call.linear(1.0 / pi, program.add(ValueOp::angle, {away, z}));
    return {{},
            {{down, program.add(ValueOp::combine, {turn, positive}, {1.0, -1.0, 1.0}),
              program.add(ValueOp::length, {away, z})},
             {}}};
}

LoweredNode map_cylindrical(const LoweringCall& call) {
    ValueProgram& program = *call.program;
    const Register away = off_axis(call), z = call.axis(2);
    Register height = z;
    if (call.parameter("height") == 1.0)
        height = program.add(ValueOp::ratio, {z, program.add(ValueOp::length, {away, z})});
    return {{}, {{call.linear(0.5 / pi, angle(call), 0.5), height, away}, {}}};
}

constexpr std::array pattern_table{NamedLowering{"constant", constant},
                                   NamedLowering{"coordinate", coordinate},
                                   NamedLowering{"add", add},
                                   NamedLowering{"multiply", multiply},
                                   NamedLowering{"min", of_two<ValueOp::minimum>},
                                   NamedLowering{"max", of_two<ValueOp::maximum>},
                                   NamedLowering{"abs", of_one<ValueOp::absolute>},
                                   NamedLowering{"power", power},
                                   NamedLowering{"sin", of_one<ValueOp::sine>},
                                   NamedLowering{"slope", slope},
                                   NamedLowering{"floor", of_one<ValueOp::floor>},
                                   NamedLowering{"fract", of_one<ValueOp::fract>},
                                   NamedLowering{"smoothstep", smoothstep},
                                   NamedLowering{"scale", scale},
                                   NamedLowering{"mix", mix},
                                   NamedLowering{"bilerp", bilerp},
                                   NamedLowering{"color_map", color_map},
                                   NamedLowering{"layer_over", layer_over},
                                   NamedLowering{"image", image},
                                   NamedLowering{"uv", uv},
                                   NamedLowering{"checkerboard", checkerboard},
                                   NamedLowering{"checkerboard_3d", checkerboard_3d},
                                   NamedLowering{"stripes", stripes},
                                   NamedLowering{"ramp", ramp},
                                   NamedLowering{"sine", sine},
                                   NamedLowering{"rings", rings},
                                   NamedLowering{"wood_grain", wood_grain},
                                   NamedLowering{"transform", transform},
                                   NamedLowering{"map_uv", map_uv},
                                   NamedLowering{"map_spherical", map_spherical},
                                   NamedLowering{"map_cylindrical", map_cylindrical},
                                   NamedLowering{"map_planar", map_planar}};

}  // namespace

std::span<const NamedLowering> pattern_lowerings() {
    return pattern_table;
}

}  // namespace burl
