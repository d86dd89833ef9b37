// Noises that MaterialX defines by other nodes.
#include <array>
#include <numbers>

#include "app/materialx/nodes.h"

namespace burl::materialx {

namespace {

/// The degrees by which a whole unit of jitter turns the place.
constexpr double degrees_of_jitter = 90000.0;

NodeRef noise_node(const NodeCall& call, const char* node, NodeRef position, int dimensions,
                   NodeInputs inputs = {}, Json parameters = Json::object()) {
    inputs.insert(inputs.begin(), {"position", position});
    parameters["dimensions"] = dimensions == 2 ? "2" : "3";
    return call.nodes().node(node, false, std::move(inputs), std::move(parameters));
}

/// The place of a unified noise, times its frequency and moved.
struct UnifiedPlace {
    Value plain;       ///< of Worley's noise, which takes the jitter itself
    NodeRef jittered;  ///< of the others, which are turned by it
    NodeRef angle;     ///< in degrees
    int dimensions;
};

UnifiedPlace unified_place(const NodeCall& call) {
    Arithmetic& values = call.values();
    NodeBuilder& nodes = call.nodes();
    const bool flat = call.node.tag.ends_with("2d");
    const Type type = flat ? Type::vector2 : Type::vector3;
    Value at = flat ? call.geometry("texcoord", "UV0") : call.geometry("position", "Pobject");
    at = values.apply("multiply", type, {at, call.in("freq", type, 1.0)});
    at = values.apply("add", type, {at, call.in("offset", type, 0.0)});
    const NodeRef jitter = nodes.math("subtract", {call.number("jitter", 1.0), nodes.number(1.0)});
    const NodeRef angle = nodes.math("multiply", {jitter, nodes.number(degrees_of_jitter)});
    NodeRef jittered = values.vector(at);
    if (nodes.constant(angle) != 0.0 && flat)
        jittered = values.vector(turned(
            values, at, nodes.math("multiply", {angle, nodes.number(std::numbers::pi / 180.0)})));
    else if (nodes.constant(angle) != 0.0)
        jittered = nodes.vector_math(
            "rotate3d",
            {jittered, values.packed(values.constant(Type::vector3, {0.1, 1.0, 0.0})), angle});
    return {at, jittered, angle, flat ? 2 : 3};
}

NodeRef half_noise(const NodeCall& call, const UnifiedPlace& at) {
    NodeBuilder& nodes = call.nodes();
    const NodeRef half = nodes.number(0.5);
    const NodeRef noise = noise_node(call, "materialx_noise", at.jittered, at.dimensions);
    return nodes.math("add", {nodes.math("multiply", {noise, half}), half});
}

std::optional<NodeRef> unified_worley(const NodeCall& call, const UnifiedPlace& at) {
    const auto style = call.constant("style", 0.0);
    if (style != 0.0 && style != 1.0) return {};
    return noise_node(call, "materialx_worley", call.values().vector(at.plain), at.dimensions,
                      {{"jitter", call.number("jitter", 1.0)}},
                      {{"style", style == 0.0 ? "distance" : "solid"}});
}

/// The fractal, which is of three dimensions always; of two the third is the jitter's angle.
NodeRef unified_fractal(const NodeCall& call, const UnifiedPlace& at) {
    Arithmetic& values = call.values();
    NodeRef position = at.jittered;
    if (at.dimensions == 2)
        position =
            call.nodes().combined({values.part(at.plain, 0), values.part(at.plain, 1), at.angle});
    return noise_node(call, "materialx_fractal", position, 3,
                      {{"octaves", values.part(call.in("octaves", Type::integer, 3.0), 0)},
                       {"lacunarity", call.number("lacunarity", 2.0)},
                       {"diminish", call.number("diminish", 0.5)}});
}

std::optional<NodeRef> unified_kind(const NodeCall& call, double kind) {
    const UnifiedPlace at = unified_place(call);
    if (kind == 0.0) return half_noise(call, at);
    if (kind == 1.0) return noise_node(call, "materialx_cellnoise", at.jittered, at.dimensions);
    if (kind == 2.0) return unified_worley(call, at);
    if (kind == 3.0) return unified_fractal(call, at);
    return {};
}

/// The number taken from [0, 1] to [low, high], and kept there if asked.
NodeRef in_range(NodeBuilder& nodes, NodeRef number, NodeRef low, NodeRef high, bool clamps) {
    const NodeRef rise = nodes.math("multiply", {number, nodes.math("subtract", {high, low})});
    const NodeRef result = nodes.math("add", {low, rise});
    return clamps ? nodes.math("clamp", {result, low, high}) : result;
}

Value unified(const NodeCall& call) {
    const auto kind = call.constant("type", 0.0), clamps = call.constant("clampoutput", 1.0);
    if (!kind) return call.varies("type");
    if (!clamps) return call.varies("clampoutput");
    const auto noise = unified_kind(call, *kind);
    if (!noise) return call.refused("its type or style is none that is known");
    return call.made(in_range(call.nodes(), *noise, call.number("outmin", 0.0),
                              call.number("outmax", 1.0), *clamps != 0.0));
}

/// A random number of another one, whose fraction counts by 4096ths unless it is an integer's.
NodeRef random_number(const NodeCall& call, NodeRef seed, bool of_integer) {
    NodeBuilder& nodes = call.nodes();
    NodeRef first = call.number("in", 0.0);
    if (!of_integer) first = nodes.math("multiply", {first, nodes.number(4096.0)});
    return noise_node(call, "materialx_cellnoise", nodes.combined({first, seed, nodes.number(0.0)}),
                      2);
}

Value random_float(const NodeCall& call) {
    const bool of_integer = call.any("in").type == Type::integer;
    const NodeRef random =
        random_number(call, call.values().part(call.in("seed", Type::integer, 0.0), 0), of_integer);
    return call.made(
        in_range(call.nodes(), random, call.number("min", 0.0), call.number("max", 1.0), true));
}

Value random_color(const NodeCall& call) {
    NodeBuilder& nodes = call.nodes();
    const NodeRef seed = call.values().part(call.in("seed", Type::integer, 0.0), 0);
    const auto component = [&](double offset, const char* low, double low_otherwise,
                               const char* high) {
        const NodeRef own = nodes.math("ceil", {nodes.math("add", {seed, nodes.number(offset)})});
        return in_range(nodes, random_number(call, own, false), call.number(low, low_otherwise),
                        call.number(high, 1.0), false);
    };
    const NodeRef hsv = nodes.combined({component(413.3, "huelow", 0.0, "huehigh"),
                                        component(1522.4, "saturationlow", 0.825, "saturationhigh"),
                                        component(1813.8, "brightnesslow", 1.0, "brightnesshigh")});
    return call.values().of_color(call.type, nodes.vector_math("hsvtorgb", {hsv}));
}

/// Squares of two colours, by whether the sum of the cell's indices is even.
Value checkerboard(const NodeCall& call) {
    Arithmetic& values = call.values();
    const Value tiled =
        values.apply("multiply", Type::vector2,
                     {call.geometry("texcoord", "UV0"), call.in("uvtiling", Type::vector2, 8.0)});
    const Value moved_by =
        values.apply("subtract", Type::vector2, {tiled, call.in("uvoffset", Type::vector2, 0.0)});
    const Value cell = values.apply("floor", Type::vector2, {moved_by});
    const NodeRef sum = call.nodes().math("add", {values.part(cell, 0), values.part(cell, 1)});
    const NodeRef odd = call.nodes().math("modulo", {sum, call.nodes().number(2.0)});
    return values.apply("mix", call.type,
                        {call.in("color2", 0.0), call.in("color1", 1.0), values.number(odd)});
}

/// 1 inside of a circle.
Value circle(const NodeCall& call) {
    Arithmetic& values = call.values();
    NodeBuilder& nodes = call.nodes();
    const Value way =
        values.apply("subtract", Type::vector2,
                     {call.geometry("texcoord", "UV0"), call.in("center", Type::vector2, 0.0)});
    const NodeRef square = values.number_of("dotproduct", {way, way});
    const NodeRef radius = call.number("radius", 0.5);
    const NodeRef outside =
        nodes.math("ifgreater", {square, nodes.math("multiply", {radius, radius})});
    return call.made(nodes.math("subtract", {nodes.number(1.0), outside}));
}

}  // namespace

std::span<const NodeRow> unified_rows() {
    static constexpr std::array rows{
        NodeRow{"unifiednoise2d", unified},    NodeRow{"unifiednoise3d", unified},
        NodeRow{"randomfloat", random_float},  NodeRow{"randomcolor", random_color},
        NodeRow{"checkerboard", checkerboard}, NodeRow{"circle", circle}};
    return rows;
}

}  // namespace burl::materialx
