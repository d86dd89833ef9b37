// MaterialX's noises and arithmetic, with its definitions (procedural/materialx). A vector is a
// colour whose red, green and blue are its components; colours are opaque.
#include "procedural/graph/node_ops.h"

namespace burl::nodes {

namespace {

using Function = MaterialXFunction;

/// A noise whose node has as many results as `results` says, 1 or 3.
MaterialXCall noise_call(const NodeOps& node, Function function, int results) {
    const int dimensions = node.parameter("dimensions") == 0.0 ? 2 : 3;
    return {function, int(node.parameter("style")), dimensions, results};
}

template <MaterialXFunction function>
Outputs one_noise(NodeOps& node) {
    return {node.apply(noise_call(node, function, 1), node.numbers())};
}
template <MaterialXFunction function>
Outputs three_noises(NodeOps& node) {
    return node.opaque(noise_call(node, function, 3), node.numbers());
}

Outputs operation_of_numbers(NodeOps& node) {
    return {node.apply(MaterialXCall{Function::math, int(node.parameter("operation"))},
                       node.numbers())};
}
Outputs operation_of_vectors(NodeOps& node) {
    return node.opaque(MaterialXCall{Function::vector_math, int(node.parameter("operation"))},
                       node.numbers());
}

constexpr std::string_view materialx = "MaterialX 1.39";
constexpr NodeInput position = a_color("position", "where it is evaluated", R"({"node": "point"})");
constexpr Inputs position_input{position};
constexpr Inputs octaves_inputs{position, a_number("octaves", "how many, whole, at most 100", "3"),
                                a_number("lacunarity", "frequency ratio of octaves", "2"),
                                a_number("diminish", "weight ratio of octaves", "0.5")};
constexpr Inputs worley_inputs{
    position, a_number("jitter", "how far points stray from the middles of their cells", "1")};
constexpr Parameter dimensions = one_of("dimensions", "\"3\"", "2|3", "2: of red and green alone");
constexpr Parameter style = one_of("style", "\"distance\"", "distance|solid",
                                   "distances, or a random number of the nearest point's cell");

constexpr std::array materialx_rows{
    a_node("materialx_noise", NodeResult::number, one_noise<Function::noise>,
           "noise2d and noise3d, amplitude 1", materialx, position_input, {dimensions}),
    a_node("materialx_noise_color", NodeResult::color, three_noises<Function::noise>,
           "three noises of noise2d and noise3d", materialx, position_input, {dimensions}),
    a_node("materialx_fractal", NodeResult::number, one_noise<Function::fractal>,
           "fractal2d and fractal3d, amplitude 1", materialx, octaves_inputs, {dimensions}),
    a_node("materialx_fractal_color", NodeResult::color, three_noises<Function::fractal>,
           "three sums of fractal2d and fractal3d", materialx, octaves_inputs, {dimensions}),
    a_node("materialx_cellnoise", NodeResult::number, one_noise<Function::cell_noise>,
           "cellnoise2d and cellnoise3d: a random number of a cell", materialx, position_input,
           {dimensions}),
    a_node("materialx_cellnoise_color", NodeResult::color, three_noises<Function::cell_noise>,
           "three random numbers of a cell", materialx, position_input, {dimensions}),
    a_node("materialx_worley", NodeResult::number, one_noise<Function::worley>,
           "worleynoise2d and worleynoise3d: the distance of the nearest point", materialx,
           worley_inputs, {dimensions, style}),
    a_node("materialx_worley_color", NodeResult::color, three_noises<Function::worley>,
           "the distances of the three nearest points", materialx, worley_inputs,
           {dimensions, style}),
    a_node("materialx_math", NodeResult::number, operation_of_numbers, "a node of arithmetic",
           materialx,
           {a_number("a", "the first input; of mix the background", "0"),
            a_number("b", "the second; low; the foreground", "0"),
            a_number("c", "the third; high; the mix", "0")},
           {one_of("operation", "\"add\"",
                   "add|subtract|multiply|divide|modulo|power|safepower|absval|sign|floor|ceil|"
                   "round|fract|sin|cos|tan|asin|acos|atan2|sqrt|ln|exp|min|max|clamp|smoothstep|"
                   "mix|trianglewave|burn|dodge|screen|overlay|difference|plus|minus|ifgreater|"
                   "ifgreatereq|ifequal",
                   "which node")}),
    a_node("materialx_vector_math", NodeResult::color, operation_of_vectors,
           "a node of arithmetic of colours and vectors; numbers come three times", materialx,
           {a_color("a", "the first input; of mix the background", "0"),
            a_color("b", "the second; low; the foreground; axis, normal or weights", "0"),
            a_color("c", "the third; high; the mix; in red degrees or index", "0")},
           {one_of("operation", "\"add\"",
                   "add|subtract|multiply|divide|modulo|power|safepower|absval|sign|floor|ceil|"
                   "round|fract|sin|cos|tan|asin|acos|atan2|sqrt|ln|exp|min|max|clamp|smoothstep|"
                   "mix|trianglewave|burn|dodge|screen|overlay|difference|plus|minus|dotproduct|"
                   "crossproduct|normalize|magnitude|distance|rotate3d|reflect|refract|luminance|"
                   "rgbtohsv|hsvtorgb",
                   "which node")}),
};

}  // namespace

std::span<const NodeType> materialx_nodes() {
    return materialx_rows;
}

}  // namespace burl::nodes
