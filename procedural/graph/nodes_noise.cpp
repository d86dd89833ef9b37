// The irregular textures: the field of the 1999 model, and those of pbrt after Chuang's slides
// (2008).
#include <algorithm>
#include <cmath>

#include "procedural/graph/node_ops.h"
#include "procedural/noise/names.h"

namespace burl::nodes {

namespace {

/// The noise of the parameters kind, seed, time and time_period.
NoiseSpec noise_of(const NodeParameters& node) {
    NoiseSpec noise;
    noise.kind = NoiseKind(int(node.parameter("kind")));
    noise.seed = std::uint32_t(node.parameter("seed"));
    const double time = node.parameter("time");
    if (std::isfinite(time)) {
        noise.time = time;
        noise.period[3] = std::uint32_t(node.parameter("time_period"));
    }
    return noise;
}

OctaveSum octave_sum(const NodeParameters& node) {
    return {noise_of(node), node.parameter("octaves"), node.parameter("lacunarity"),
            node.parameter("gain")};
}

Outputs field(NodeOps& node) {
    return {node.apply(FieldAt{&node.texture()}, node.point())};
}

Outputs fbm(NodeOps& node) {
    return {node.octaves(octave_sum(node))};
}

Outputs wrinkled(NodeOps& node) {
    OctaveSum sum = octave_sum(node);
    sum.shape = OctaveShape::absolute;
    return {node.octaves(sum)};
}

Outputs windy(NodeOps& node) {
    OctaveSum slow = octave_sum(node);
    slow.octaves = 3.0;
    slow.scale = 0.1;
    const Register wind = node.octaves(slow), waves = node.octaves(octave_sum(node));
    return {node.multiply(node.apply(ValueOp::absolute, {wind}), waves)};
}

Outputs marble(NodeOps& node) {
    OctaveSum sum = octave_sum(node);
    sum.scale = node.parameter("scale");
    const Register noise = node.octaves(sum);
    const Register vein = node.combine(sum.scale, node.axis(1), node.parameter("variation"), noise);
    const Register t = node.linear(0.5, node.sine(vein), 0.5);
    return node.opaque(MarbleColors{node.parameter("spline") == 1.0}, {t});
}

Outputs bumps(NodeOps& node) {
    OctaveSum octave{noise_of(node), 1.0};
    octave.fades = false;
    Affine3 frequency;
    for (int i = 0; i < 3; ++i)
        frequency.linear[i][i] = node.parameter("frequency", std::size_t(i));
    const Register n = node.apply(octave, node.moved(frequency));
    BoxStep reaches{0.5, 0.5, node.parameter("threshold")};  // n in [-1,1], taken to [0,1]
    if (is_distance(octave.noise.kind)) reaches.factor = 1.0, reaches.offset = 0.0;
    return node.blend(node.apply(reaches, {n}));
}

Outputs dots(NodeOps& node) {
    const auto count = [&](const char* key) { return std::uint32_t(node.parameter(key)); };
    const DotsWeight disks{count("seed"), count("period_u"), count("period_v"),
                           node.parameter("radius")};
    return node.blend(node.apply(disks, {node.axis(0), node.axis(1)}));
}

Outputs warp(NodeOps& node) {
    const OctaveSum sum = octave_sum(node);
    Outputs result;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        OctaveSum moves = sum;
        moves.noise.seed += axis << 16;
        result.push_back(
            node.combine(1.0, node.axis(axis), node.parameter("strength"), node.octaves(moves)));
    }
    return result;
}

constexpr std::size_t kind_choices_size = [] {
    std::size_t size = 0;
    for (const Named<NoiseKind>& kind : noise_kinds) size += kind.name.size() + 1;
    return size;
}();
/// The names of all kinds of noise, each followed by a bar.
constexpr std::array<char, kind_choices_size> kind_choices = [] {
    std::array<char, kind_choices_size> text{};
    char* at = text.data();
    for (const Named<NoiseKind>& kind : noise_kinds) {
        at = std::ranges::copy(kind.name, at).out;
        *at++ = '|';
    }
    return text;
}();
static_assert(std::ranges::is_sorted(noise_kinds, {}, &Named<NoiseKind>::value),
              "nodes store the number of a kind's name");

constexpr Parameter kind_parameter =
    one_of("kind", "\"perlin\"", {kind_choices.data(), kind_choices_size - 1},
           "which noise (docs/reference/noise.md)");
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
constexpr Parameters octave_parameters(std::string_view octaves) {
    return {kind_parameter, seed_parameter, octaves_parameter(octaves), lacunarity_parameter,
            gain_parameter, time_parameter, time_period_parameter};
}

constexpr std::array noise_rows{
    a_node("field", NodeResult::number, field,
           "`quadric` plus `noise` terms, as in docs/reference/recipes.md",
           "Hart et al. 1999, equation 1"),
    a_node("fbm", NodeResult::number, fbm, "sum of gain^k noise(lacunarity^k point)", pbrt, {},
           octave_parameters("8")),
    a_node("wrinkled", NodeResult::number, wrinkled,
           "sum of gain^k abs(noise(lacunarity^k point)): turbulence", pbrt, {},
           octave_parameters("8")),
    a_node("windy", NodeResult::number, windy,
           "abs(fbm(point / 10), 3 octaves) times fbm(point): gusts that raise waves", pbrt, {},
           octave_parameters("6")),
    a_node("marble", NodeResult::color, marble,
           "a spline of nine colours over (1 + sin(t + variation fbm)) / 2", pbrt, {},
           {kind_parameter, seed_parameter, octaves_parameter("8"), lacunarity_parameter,
            gain_parameter, real("scale", 1e-6, 1e6, "1", "factor of the point"),
            real("variation", -1e3, 1e3, "0.2", "how far noise moves the veins"),
            one_of("spline", "\"bezier\"", "bezier|bspline",
                   "pbrt's, which jumps where its four colours change, or one that does not"),
            time_parameter, time_period_parameter}),
    a_node("bumps", NodeResult::inputs, bumps,
           "b where noise(frequency * point), taken to [0,1], reaches the threshold", slides,
           two_sides,
           {kind_parameter, seed_parameter,
            several("frequency", 3, "[50,50,20]", "cells per unit of s, t and r"),
            real("threshold", -1, 2, "0.5", "from here on: b"), time_parameter,
            time_period_parameter}),
    a_node("dots", NodeResult::inputs, dots,
           "in half of the unit squares a disk of b, moved about within its square", pbrt,
           two_sides,
           {seed_parameter, real("radius", 0, 0.5, "0.35", "of a disk"),
            whole("period_u", 0, 1e6, "0", "squares after which the disks repeat; 0: never"),
            whole("period_v", 0, 1e6, "0",
                  "squares along the second coordinate after which the disks repeat; 0: never")}),
    a_node("warp", NodeResult::inner, warp, "point + strength * three fbm noises of the point",
           "Perlin 1985", moved_input,
           {real("strength", -1e6, 1e6, "0.5", "how far the point is moved"), kind_parameter,
            seed_parameter, octaves_parameter("1"), lacunarity_parameter, gain_parameter,
            time_parameter, time_period_parameter}),
};

}  // namespace

std::span<const NodeType> noises() {
    return noise_rows;
}

}  // namespace burl::nodes
