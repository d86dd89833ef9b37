#include "procedural/graph/table.h"

#include "procedural/graph/nodes.h"

namespace burl {

namespace {

using enum ParameterType;
using Inputs = std::array<NodeInput, 4>;
using Parameters = std::array<Parameter, 10>;

constexpr std::string_view noise_choices =
    "value|perlin|perlin2002|perlin1985|simplex|worley|cell|white";

constexpr Parameter real(std::string_view key, double low, double high, std::string_view otherwise,
                         std::string_view tip) {
    return {key, number, low, high, 0.05, 1, "", otherwise, "", tip};
}
constexpr Parameter whole(std::string_view key, double low, double high, std::string_view otherwise,
                          std::string_view tip) {
    return {key, integer, low, high, 1, 1, "", otherwise, "", tip};
}
constexpr Parameter several(std::string_view key, std::size_t count, std::string_view otherwise,
                            std::string_view tip) {
    return {key, numbers, -1e6, 1e6, 0.1, count, "", otherwise, "", tip};
}
constexpr Parameter one_of(std::string_view key, std::string_view otherwise,
                           std::string_view choices, std::string_view tip) {
    return {key, choice, 0, 0, 0, 1, "", otherwise, choices, tip};
}

constexpr NodeInput a_number(std::string_view key, std::string_view tip,
                             std::string_view otherwise = {}) {
    return {key, Wire::number, false, otherwise, tip};
}
constexpr NodeInput any(std::string_view key, std::string_view tip,
                        std::string_view otherwise = {}) {
    return {key, Wire::color, true, otherwise, tip};
}

constexpr Parameter kind_parameter =
    one_of("kind", "\"perlin\"", noise_choices, "which noise (docs/reference/noise.md)");
constexpr Parameter seed_parameter =
    whole("seed", 0, 4294967295.0, "0", "number of the random lattice; octave k uses seed + k");
constexpr Parameter lacunarity_parameter =
    real("lacunarity", 0.01, 16, "2", "frequency ratio from one octave to the next");
constexpr Parameter gain_parameter =
    real("gain", 0, 2, "0.5", "amplitude ratio from one octave to the next");
constexpr Parameter time_parameter =
    real("time", -1e9, 1e9, "null", "fourth lattice coordinate; null: noise of three dimensions");
constexpr Parameter time_period_parameter = whole(
    "time_period", 0, 1073741824, "0", "cells along time after which the noise repeats; 0: never");
constexpr Parameter octaves_parameter(std::string_view otherwise) {
    return whole("octaves", 1, 24, otherwise, "how many octaves are summed");
}
constexpr Parameters octave_sum(std::string_view octaves) {
    return {kind_parameter, seed_parameter, octaves_parameter(octaves), lacunarity_parameter,
            gain_parameter, time_parameter, time_period_parameter};
}

constexpr Inputs one_number{a_number("input", "a number")};
constexpr Inputs two_numbers{a_number("a", "a number"), a_number("b", "a number")};
constexpr Inputs two_sides{any("a", "where the pattern is 0", "0"),
                           any("b", "where the pattern is 1", "1")};
constexpr Inputs moved_input{any("input", "what is evaluated at the point made here")};

constexpr Parameters checker_parameters{
    one_of("aa", "\"closed_form\"", "none|closed_form|supersample|trapezoid",
           "none, pbrt's share of b in a box, its 4 x 4 stratified samples, or the share over the "
           "texel's two sides")};
constexpr Parameters along_parameters{
    several("direction", 3, "[1,0,0]", "the point's component along it counts"),
    real("period", 1e-6, 1e6, "1", "length after which a cell ends")};

constexpr std::string_view slides = "Chuang 2008", pbrt = "pbrt (Chuang 2008)", own = "-";

constexpr std::array node_table{
    // Numbers and arithmetic
    NodeType{"constant", NodeResult::inputs, nodes::constant,
             "a number or an sRGB colour, `value`; also written as the bare value", pbrt},
    NodeType{"coordinate",
             NodeResult::number,
             nodes::coordinate,
             "direction . point + offset",
             own,
             {},
             {several("direction", 3, "[1,0,0]", "weights of the point's coordinates"),
              real("offset", -1e6, 1e6, "0", "added")}},
    NodeType{"add", NodeResult::number, nodes::add, "a + b", own, two_numbers},
    NodeType{"multiply", NodeResult::number, nodes::multiply, "a b", own, two_numbers},
    NodeType{"min", NodeResult::number, nodes::minimum, "the smaller of a and b", own, two_numbers},
    NodeType{"max", NodeResult::number, nodes::maximum, "the larger of a and b", own, two_numbers},
    NodeType{"abs", NodeResult::number, nodes::absolute, "the absolute value of input", own,
             one_number},
    NodeType{"power",
             NodeResult::number,
             nodes::power,
             "input^exponent; a negative input counts as 0 unless the exponent is whole",
             own,
             one_number,
             {real("exponent", 0, 64, "2", "the exponent")}},
    NodeType{"sin", NodeResult::number, nodes::sine_of, "sin(input), in radians", own, one_number},
    NodeType{"slope",
             NodeResult::number,
             nodes::slope,
             "direction . gradient of input with respect to the solid point; its own is given as 0",
             "DNoise of Perlin 1985",
             one_number,
             {several("direction", 3, "[1,0,0]", "along which input's growth is taken")}},
    NodeType{"floor", NodeResult::number, nodes::floor_of,
             "the largest whole number not above input", own, one_number},
    NodeType{"fract", NodeResult::number, nodes::fract_of, "input - floor(input)", slides,
             one_number},
    NodeType{"smoothstep",
             NodeResult::number,
             nodes::smoothstep,
             "0 up to low, 1 from high on, 3u^2 - 2u^3 between",
             own,
             one_number,
             {real("low", -1e6, 1e6, "0", "where it leaves 0"),
              real("high", -1e6, 1e6, "1", "where it reaches 1; at or below low: a step")}},
    // Weighted sums
    NodeType{"scale",
             NodeResult::inputs,
             nodes::scale,
             "a b, channel by channel",
             pbrt,
             {any("a", "a factor"), any("b", "a factor")}},
    NodeType{"mix",
             NodeResult::inputs,
             nodes::mix,
             "(1 - amount) a + amount b",
             pbrt,
             {any("a", "at amount 0", "0"), any("b", "at amount 1", "1"),
              a_number("amount", "weight of b", "0.5")}},
    NodeType{"bilerp",
             NodeResult::inputs,
             nodes::bilerp,
             "four values interpolated by the point's first two coordinates, u and v",
             pbrt,
             {any("v00", "at u = 0, v = 0", "0"), any("v01", "at u = 0, v = 1", "1"),
              any("v10", "at u = 1, v = 0", "0"), any("v11", "at u = 1, v = 1", "1")}},
    // Colours
    NodeType{"color_map", NodeResult::color, nodes::color_map,
             "colour `stops` over a number, index repeated or clamped (`wrap`)", "Hart et al. 1999",
             one_number},
    NodeType{"layer_over",
             NodeResult::color,
             nodes::layer_over,
             "top over base by top's alpha times opacity",
             "Porter and Duff 1984",
             {NodeInput{"top", Wire::color, false, "", "the upper layer"},
              NodeInput{"base", Wire::color, false, "", "what it covers"},
              a_number("opacity", "factor of top's alpha, clamped to [0,1]", "1")}},
    NodeType{"image",
             NodeResult::color,
             nodes::image,
             "an image over [0,1]^2 of the point's first two coordinates, row 0 from 0 on",
             pbrt,
             {},
             {Parameter{"file", text, 0, 0, 0, 0, "", "", "", "a PNG, from the recipe's folder on"},
              one_of("lookup", "\"trilinear\"", "trilinear|ewa",
                     "between MIP levels, or an elliptically weighted average"),
              one_of("wrap", "\"repeat\"", "repeat|black|clamp", "what lies beyond the image"),
              real("anisotropy", 1, 32, "8", "most unequal axes of an ellipse; ewa only")}},
    // Patterns
    NodeType{"uv", NodeResult::color, nodes::uv,
             "red and green are the fractions of the point's first two coordinates", pbrt},
    NodeType{"checkerboard", NodeResult::inputs, nodes::checkerboard,
             "unit squares in the point's first two coordinates", pbrt, two_sides,
             checker_parameters},
    NodeType{"checkerboard_3d", NodeResult::inputs, nodes::checkerboard_3d, "unit cubes", pbrt,
             two_sides, checker_parameters},
    NodeType{"stripes", NodeResult::inputs, nodes::stripes,
             "slabs one period thick, across a direction", slides, two_sides, along_parameters},
    NodeType{"ramp", NodeResult::inputs, nodes::ramp, "from a to b over each period: mod(x, p) / p",
             slides, two_sides, along_parameters},
    NodeType{"sine", NodeResult::inputs, nodes::sine,
             "between a and b as (sin(2 pi x / period) + 1) / 2", slides, two_sides,
             along_parameters},
    NodeType{"rings",
             NodeResult::inputs,
             nodes::rings,
             "tubes round the r axis",
             slides,
             two_sides,
             {real("spacing", 1e-6, 1e6, "1", "thickness of a ring")}},
    NodeType{"wood_grain",
             NodeResult::inputs,
             nodes::wood_grain,
             "rings of distance / spacing + wobble sin(wobbles angle + twist r)",
             slides,
             two_sides,
             {real("spacing", 1e-6, 1e6, "1", "thickness of a ring"),
              real("wobble", 0, 1e3, "0.2", "how far a ring strays, in rings"),
              whole("wobbles", 0, 1000, "5", "how often in one turn"),
              real("twist", -1e6, 1e6, "0", "radians by which the wobble turns per unit of r"),
              one_of("profile", "\"hard\"", "hard|ramp",
                     "rings change from a to b, or rise from a to b and fall back")}},
    // Noise
    NodeType{"field", NodeResult::number, nodes::field,
             "`quadric` plus `noise` terms, as in docs/reference/recipes.md",
             "Hart et al. 1999, equation 1"},
    NodeType{"fbm",
             NodeResult::number,
             nodes::fbm,
             "sum of gain^k noise(lacunarity^k point)",
             pbrt,
             {},
             octave_sum("8")},
    NodeType{"wrinkled",
             NodeResult::number,
             nodes::wrinkled,
             "sum of gain^k abs(noise(lacunarity^k point)): turbulence",
             pbrt,
             {},
             octave_sum("8")},
    NodeType{"windy",
             NodeResult::number,
             nodes::windy,
             "abs(fbm(point / 10), 3 octaves) times fbm(point): gusts that raise waves",
             pbrt,
             {},
             octave_sum("6")},
    NodeType{"marble",
             NodeResult::color,
             nodes::marble,
             "a spline of nine colours over (1 + sin(t + variation fbm)) / 2",
             pbrt,
             {},
             {kind_parameter, seed_parameter, octaves_parameter("8"), lacunarity_parameter,
              gain_parameter, real("scale", 1e-6, 1e6, "1", "factor of the point"),
              real("variation", -1e3, 1e3, "0.2", "how far noise moves the veins"),
              one_of("spline", "\"bezier\"", "bezier|bspline",
                     "pbrt's, which jumps where its four colours change, or one that does not"),
              time_parameter, time_period_parameter}},
    NodeType{"bumps",
             NodeResult::inputs,
             nodes::bumps,
             "b where noise(frequency * point), taken to [0,1], reaches the threshold",
             slides,
             two_sides,
             {kind_parameter, seed_parameter,
              several("frequency", 3, "[50,50,20]", "cells per unit of s, t and r"),
              real("threshold", -1, 2, "0.5", "from here on: b"), time_parameter,
              time_period_parameter}},
    NodeType{"dots",
             NodeResult::inputs,
             nodes::dots,
             "in half of the unit squares a disk of b, moved about within its square",
             pbrt,
             two_sides,
             {seed_parameter, real("radius", 0, 0.5, "0.35", "of a disk"),
              whole("period_u", 0, 1e6, "0", "squares after which the disks repeat; 0: never"),
              whole("period_v", 0, 1e6, "0", "the same along the second coordinate")}},
    // Points
    NodeType{"transform",
             NodeResult::inner,
             nodes::transform,
             "matrix (translate + rotate scale point); pbrt's 3-D mapping",
             pbrt,
             moved_input,
             {several("scale", 3, "[1,1,1]", "factors of the coordinates"),
              several("rotate", 3, "[0,0,0]", "degrees about the first, second and third axis"),
              several("translate", 3, "[0,0,0]", "added"),
              several("matrix", 12, "[1,0,0,0,0,1,0,0,0,0,1,0]", "3 rows of 4, applied last")}},
    NodeType{"warp",
             NodeResult::inner,
             nodes::warp,
             "point + strength * three fbm noises of the point",
             "Perlin 1985",
             moved_input,
             {real("strength", -1e6, 1e6, "0.5", "how far the point is moved"), kind_parameter,
              seed_parameter, octaves_parameter("1"), lacunarity_parameter, gain_parameter,
              time_parameter, time_period_parameter}},
    NodeType{"map_uv",
             NodeResult::inner,
             nodes::map_uv,
             "(scale u + offset, third coordinate) of the point's first two, u",
             pbrt,
             moved_input,
             {several("scale", 2, "[1,1]", "factors"), several("offset", 2, "[0,0]", "added")}},
    NodeType{"map_spherical", NodeResult::inner, nodes::map_spherical,
             "(angle from the r axis / pi, turn about it in [0,1), distance)", pbrt, moved_input},
    NodeType{"map_cylindrical",
             NodeResult::inner,
             nodes::map_cylindrical,
             "(turn about the r axis in [0,1], height, distance from it)",
             pbrt,
             moved_input,
             {one_of("height", "\"axis\"", "axis|normalized",
                     "r itself, or (pbrt) r over the distance from the origin")}},
    NodeType{
        "map_planar",
        NodeResult::inner,
        nodes::map_planar,
        "(vs . point, vt . point, 0) + offset",
        pbrt,
        moved_input,
        {several("vs", 3, "[1,0,0]", "gives the first coordinate"),
         several("vt", 3, "[0,1,0]", "gives the second"), several("offset", 2, "[0,0]", "added")}},
};

}  // namespace

std::span<const NodeInput> NodeType::inputs() const {
    std::size_t count = 0;
    while (count < input_list.size() && !input_list[count].key.empty()) ++count;
    return {input_list.data(), count};
}

std::span<const Parameter> NodeType::parameters() const {
    std::size_t count = 0;
    while (count < parameter_list.size() && !parameter_list[count].path.empty()) ++count;
    return {parameter_list.data(), count};
}

const NodeInput* NodeType::input(std::string_view key) const {
    for (const NodeInput& candidate : inputs())
        if (candidate.key == key) return &candidate;
    return nullptr;
}

std::span<const NodeType> graph_table() {
    return node_table;
}

const NodeType* find_node(std::string_view name) {
    for (const NodeType& type : node_table)
        if (type.name == name) return &type;
    return nullptr;
}

}  // namespace burl
