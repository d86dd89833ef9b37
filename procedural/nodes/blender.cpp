// The textures and arithmetic of Blender's shader nodes, with its definitions (procedural/blender).
// A vector is a colour whose red, green and blue are its coordinates; colours are opaque.
#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

using Call = BlenderFunction;

double chosen(const NodeParameters& node, std::string_view key) {
    return node.parameter(key);
}

/// The three numbers of input k, each times input `scale`.
Outputs scaled(NodeOps& node, std::size_t k, std::size_t scale) {
    Outputs result;
    for (std::size_t c = 0; c < 3; ++c)
        result.push_back(node.multiply(node.input(k, c), node.input(scale)));
    return result;
}

/// The numbers of a texture's inputs: the vector times the scale, which are the first two, and the
/// others.
Outputs texture_inputs(NodeOps& node) {
    Outputs all = scaled(node, 0, 1);
    const Outputs others = node.numbers(2);
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

Outputs point(NodeOps& node) {
    return {node.axis(0), node.axis(1), node.axis(2), node.constant(1.0)};
}

Outputs noise(NodeOps& node) {
    return {node.apply(BlenderCall{Call::noise, {0.0}}, texture_inputs(node))};
}
Outputs noise_color(NodeOps& node) {
    return node.opaque(BlenderCall{Call::noise, {1.0}}, texture_inputs(node));
}

Outputs musgrave(NodeOps& node) {
    return {node.apply(BlenderCall{Call::musgrave, {chosen(node, "kind")}}, texture_inputs(node))};
}

BlenderCall voronoi_call(const NodeParameters& node, double gives) {
    return {Call::voronoi, {chosen(node, "feature"), chosen(node, "metric"), gives}};
}
Outputs voronoi(NodeOps& node) {
    return {node.apply(voronoi_call(node, 0.0), texture_inputs(node))};
}
Outputs voronoi_color(NodeOps& node) {
    const bool position = chosen(node, "gives") == 1.0;
    Outputs result = node.opaque(voronoi_call(node, position ? 2.0 : 1.0), texture_inputs(node));
    if (!position) return result;
    const BlenderCall divide{Call::math, {3.0}};
    for (std::size_t c = 0; c < 3; ++c) result[c] = node.apply(divide, {result[c], node.input(1)});
    return result;
}

Outputs wave(NodeOps& node) {
    const double rings = chosen(node, "kind");
    return {node.apply(
        BlenderCall{Call::wave, {rings, chosen(node, "direction"), chosen(node, "profile")}},
        texture_inputs(node))};
}

Outputs magic(NodeOps& node) {
    return node.opaque(BlenderCall{Call::magic, {chosen(node, "depth")}}, texture_inputs(node));
}

Outputs gradient(NodeOps& node) {
    return {node.apply(BlenderCall{Call::gradient, {chosen(node, "kind")}}, node.numbers())};
}

Outputs brick(NodeOps& node) {
    const BlenderCall call{Call::brick,
                           {node.parameter("offset"), node.parameter("offset_frequency"),
                            node.parameter("squash"), node.parameter("squash_frequency")}};
    const Outputs shares = node.add(call, texture_inputs(node), 2);
    return {shares[std::size_t(node.parameter("gives"))]};
}

Outputs checker(NodeOps& node) {
    return {node.apply(BlenderCall{Call::checker, {}}, texture_inputs(node))};
}

Outputs white_noise(NodeOps& node) {
    return {node.apply(BlenderCall{Call::white_noise, {}}, node.numbers())};
}
Outputs white_noise_color(NodeOps& node) {
    return node.opaque(BlenderCall{Call::white_noise, {}}, node.numbers());
}

Outputs math(NodeOps& node) {
    return {node.apply(BlenderCall{Call::math, {chosen(node, "operation")}}, node.numbers())};
}
Outputs vector_math(NodeOps& node) {
    return node.opaque(BlenderCall{Call::vector_math, {chosen(node, "operation")}}, node.numbers());
}
Outputs map_range(NodeOps& node) {
    return {node.apply(BlenderCall{Call::map_range, {chosen(node, "curve")}}, node.numbers())};
}
Outputs mix_colors(NodeOps& node) {
    return node.opaque(BlenderCall{Call::mix, {chosen(node, "mode")}}, node.numbers());
}

/// The definition of a node whose colour is a function of its inputs without settings.
template <BlenderFunction function>
Outputs color_of(NodeOps& node) {
    return node.opaque(BlenderCall{function, {}}, node.numbers());
}

constexpr std::string_view blender = "Blender 3.4";
constexpr NodeInput a_vector = a_color("vector", "where it is evaluated");
constexpr NodeInput scale_input = a_number("scale", "factor of the vector", "5");
constexpr NodeInput a_side = a_color("a", "a colour or vector", "0"),
                    b_side = a_color("b", "a colour or vector", "0");

constexpr NodeInput detail_input =
    a_number("detail", "octaves besides the first, 0 to 15; parts are blended in", "2");
constexpr Inputs noise_inputs{a_vector, scale_input, detail_input,
                              a_number("roughness", "weight ratio of octaves, 0 to 1", "0.5"),
                              a_number("distortion", "how far noise moves the vector", "0")};
constexpr Inputs voronoi_inputs{
    a_vector, scale_input, a_number("smoothness", "of smooth_f1, 0 to 1", "1"),
    a_number("exponent", "of the minkowski metric", "0.5"),
    a_number("randomness", "side of the cube that holds a cell's point, 0 to 1", "1")};
constexpr Parameter feature_parameter =
    one_of("feature", "\"f1\"", "f1|f2|smooth_f1|distance_to_edge|n_sphere_radius",
           "the nearest point, the second, a smooth minimum, the border, or a ball that fits");
constexpr Parameter metric_parameter =
    one_of("metric", "\"euclidean\"", "euclidean|manhattan|chebychev|minkowski",
           "how distances are measured; not of borders and balls");

constexpr std::array texture_rows{
    a_node("point", NodeResult::color, point,
           "the point as a colour: red, green and blue are its coordinates", own),
    a_node("blender_noise", NodeResult::number, noise, "the value of the Noise texture", blender,
           noise_inputs),
    a_node("blender_noise_color", NodeResult::color, noise_color, "the colour of the Noise texture",
           blender, noise_inputs),
    a_node("blender_musgrave", NodeResult::number, musgrave, "the Musgrave texture", blender,
           {a_vector, scale_input,
            a_number("detail", "octaves, 0 to 15; a part of one is weighted", "2"),
            a_number("dimension", "octaves lose weight by lacunarity to this power", "2"),
            a_number("lacunarity", "frequency ratio of octaves", "2"),
            a_number("offset", "added to noise; not in multifractal and fbm", "0"),
            a_number("gain", "of hybrid and ridged", "1")},
           {one_of("kind", "\"fbm\"", "multifractal|ridged|hybrid|fbm|hetero_terrain",
                   "how octaves are joined")}),
    a_node("blender_voronoi", NodeResult::number, voronoi, "the distance of the Voronoi texture",
           blender, voronoi_inputs, {feature_parameter, metric_parameter}),
    a_node("blender_voronoi_color", NodeResult::color, voronoi_color,
           "the colour or the position of the Voronoi texture", blender, voronoi_inputs,
           {feature_parameter, metric_parameter,
            one_of("gives", "\"color\"", "color|position",
                   "a random colour of the cell, or its point")}),
    a_node("blender_wave", NodeResult::number, wave, "the Wave texture", blender,
           {a_vector, scale_input, a_number("distortion", "by noise", "0"),
            a_number("detail", "octaves of the noise besides the first", "2"),
            a_number("detail_scale", "factor of the vector for the noise", "1"),
            a_number("detail_roughness", "weight ratio of octaves", "0.5"),
            a_number("phase", "added, in radians", "0")},
           {one_of("kind", "\"bands\"", "bands|rings", "planes, or tubes and spheres"),
            one_of("direction", "\"x\"", "x|y|z|all",
                   "the axis; all: the diagonal of bands, or spheres"),
            one_of("profile", "\"sine\"", "sine|saw|triangle", "the form of a wave")}),
    a_node("blender_magic", NodeResult::color, magic, "the Magic texture", blender,
           {a_vector, scale_input, a_number("distortion", "of the pattern", "1")},
           {whole("depth", 0, 10, "2", "how often it is turned")}),
    a_node(
        "blender_gradient", NodeResult::number, gradient, "the Gradient texture", blender,
        {a_vector},
        {one_of("kind", "\"linear\"",
                "linear|quadratic|easing|diagonal|spherical|quadratic_sphere|radial", "its form")}),
    a_node("blender_brick", NodeResult::number, brick, "the Brick texture's shares", blender,
           {a_vector, scale_input, a_number("mortar", "width of mortar on a brick's side", "0.02"),
            a_number("smooth", "share of the mortar that blends", "0.1"),
            a_number("bias", "added to a brick's number", "0"),
            a_number("width", "of a brick", "0.5"), a_number("height", "of a row", "0.25")},
           {one_of("gives", "\"tint\"", "tint|mortar",
                   "a random number of the brick, or the mortar's share"),
            real("offset", 0, 1, "0.5", "how far rows are moved, in widths"),
            whole("offset_frequency", 1, 99, "2", "every how many rows are moved"),
            real("squash", 0, 99, "1", "factor of the width"),
            whole("squash_frequency", 1, 99, "2", "every how many rows are squashed")}),
    a_node("blender_checker", NodeResult::number, checker,
           "the Checker texture: 1 where the first colour shows", blender, {a_vector, scale_input}),
    a_node("blender_white_noise", NodeResult::number, white_noise,
           "a random number of the vector's bits in float32", blender, {a_vector}),
    a_node("blender_white_noise_color", NodeResult::color, white_noise_color,
           "a random colour of the vector's bits in float32", blender, {a_vector}),
};

constexpr std::array operation_rows{
    a_node("blender_math", NodeResult::number, math, "the Math node", blender,
           {a_number("a", "a number", "0"), a_number("b", "a number", "0"),
            a_number("c", "a number", "0")},
           {one_of("operation", "\"add\"",
                   "add|subtract|multiply|divide|multiply_add|power|logarithm|sqrt|inverse_sqrt|"
                   "absolute|exponent|minimum|maximum|less_than|greater_than|sign|compare|"
                   "smooth_min|smooth_max|round|floor|ceil|trunc|fract|modulo|wrap|snap|pingpong|"
                   "sine|cosine|tangent|arcsine|arccosine|arctangent|arctan2|sinh|cosh|tanh|"
                   "radians|degrees",
                   "which function")}),
    a_node("blender_vector_math", NodeResult::color, vector_math,
           "the Vector Math node; numbers come three times", blender,
           {a_side, b_side, a_color("c", "a vector", "0"),
            a_number("scale", "of scale; the ratio of refract", "1")},
           {one_of("operation", "\"add\"",
                   "add|subtract|multiply|divide|multiply_add|cross_product|project|reflect|"
                   "refract|faceforward|dot_product|distance|length|scale|normalize|absolute|"
                   "minimum|maximum|floor|ceil|fraction|modulo|wrap|snap|sine|cosine|tangent",
                   "which function")}),
    a_node("blender_map_range", NodeResult::number, map_range, "the Map Range node, not clamped",
           blender,
           {a_number("input", "a number"), a_number("from_low", "what becomes to_low", "0"),
            a_number("from_high", "what becomes to_high", "1"),
            a_number("to_low", "what from_low becomes", "0"),
            a_number("to_high", "what from_high becomes", "1"),
            a_number("steps", "of the stepped curve", "4")},
           {one_of("curve", "\"linear\"", "linear|stepped|smoothstep|smootherstep",
                   "how it goes from low to high")}),
    a_node("blender_mix", NodeResult::color, mix_colors, "the Mix node of colours", blender,
           {a_number("amount", "weight of b", "0.5"), a_side, b_side},
           {one_of("mode", "\"mix\"",
                   "mix|darken|multiply|burn|lighten|screen|dodge|add|overlay|soft_light|"
                   "linear_light|difference|subtract|divide|hue|saturation|color|value",
                   "how b changes a")}),
    a_node("blender_hue_saturation", NodeResult::color, color_of<Call::correct_hsv>,
           "the Hue Saturation Value node", blender,
           {a_color("input", "a colour"), a_number("hue", "0.5 leaves it", "0.5"),
            a_number("saturation", "factor", "1"), a_number("value", "factor", "1"),
            a_number("amount", "weight of the change", "1")}),
    a_node("blender_to_hsv", NodeResult::color, color_of<Call::to_hsv>,
           "hue, saturation and value as red, green and blue", blender,
           {a_color("input", "a colour")}),
    a_node("blender_from_hsv", NodeResult::color, color_of<Call::from_hsv>,
           "the colour of a hue, a saturation and a value", blender,
           {a_number("hue", "in turns", "0"), a_number("saturation", "0 to 1", "0"),
            a_number("value", "0: black", "0")}),
    a_node("blender_contrast", NodeResult::color, color_of<Call::contrast>,
           "the Brightness and Contrast node", blender,
           {a_color("input", "a colour"), a_number("bright", "added", "0"),
            a_number("contrast", "about the middle", "0")}),
    a_node("blender_gamma", NodeResult::color, color_of<Call::gamma>, "the Gamma node", blender,
           {a_color("input", "a colour"), a_number("gamma", "the exponent", "1")}),
};

constexpr auto blender_rows = [] {
    std::array<NodeType, texture_rows.size() + operation_rows.size()> all{};
    std::ranges::copy(operation_rows, std::ranges::copy(texture_rows, all.begin()).out);
    return all;
}();

}  // namespace

std::span<const NodeType> blender_nodes() {
    return blender_rows;
}

}  // namespace burl::nodes
