// The irregular textures: the field of the 1999 model, those of pbrt after Chuang's slides (2008),
// simplex noise in many dimensions, fibres, and moves of the point by noise.
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

OctaveLadder ladder_of(const NodeParameters& node) {
    return {std::uint32_t(node.parameter("seed")), node.parameter("octaves"),
            node.parameter("lacunarity"), node.parameter("gain")};
}

Outputs simplex_nd(NodeOps& node) {
    SimplexNoise noise;
    noise.dimensions = std::size_t(node.parameter("dimensions"));
    noise.signal = SimplexSignal(int(node.parameter("signal")));
    noise.waves = node.parameter("waves");
    std::vector<Register> at = node.point();
    for (std::size_t k = 3; k < noise.dimensions; ++k)
        at.push_back(k < 7 ? node.input(k - 3) : node.constant(node.parameter("x8")));
    return {node.apply(SimplexOctaves{noise, ladder_of(node)}, at)};
}

/// The rows of a rotation that takes the direction to the first axis; the first axis itself for a
/// direction of length 0.
std::array<Vec3d, 3> frame_along(const Vec3d& direction) {
    const double length = glm::length(direction);
    const Vec3d first = length > 0.0 ? direction / length : Vec3d(1.0, 0.0, 0.0);
    const Vec3d sizes = glm::abs(first);
    const int least = sizes.x <= sizes.y && sizes.x <= sizes.z ? 0 : sizes.y <= sizes.z ? 1 : 2;
    Vec3d axis(0.0);
    axis[least] = 1.0;
    const Vec3d across = glm::cross(first, axis);
    const Vec3d second = across / glm::length(across);
    return {first, second, glm::cross(first, second)};
}

Outputs fibre(NodeOps& node) {
    const std::array<Vec3d, 3> frame = frame_along(node.vector("direction"));
    const double length = node.parameter("length"), width = node.parameter("width"),
                 stray = node.parameter("wave");
    const OctaveSum sum = octave_sum(node);
    std::vector<Register> at{node.along(frame[0] / length)};
    for (std::uint32_t side = 1; side < 3; ++side) {
        const Register across = node.along(frame[side] / width);
        if (stray == 0.0) {
            at.push_back(across);
            continue;
        }
        OctaveSum bends{sum.noise, 1.0};
        bends.noise.seed += side << 16;
        const Register bend = node.apply(
            bends, {at[0], node.along(frame[1] / length), node.along(frame[2] / length)});
        at.push_back(node.combine(1.0, across, stray / width, bend));
    }
    return {node.apply(sum, at)};
}

/// Follows the field's streamline through the point by the midpoint rule, whose steps keep volumes
/// up to the third power of their length.
Outputs curl(NodeOps& node) {
    CurlOctaves field{{}, ladder_of(node)};
    if (std::isfinite(node.parameter("time"))) field.time = node.parameter("time");
    const double steps = node.parameter("steps"), reach = node.parameter("strength") / steps;
    const auto moved = [&](const Outputs& from, double far, const Outputs& along) {
        Outputs at;
        for (const Register x : along) at.push_back(node.linear(node.parameter("scale"), x));
        const Outputs move = node.add(field, at, 3);
        Outputs result;
        for (std::size_t i = 0; i < 3; ++i)
            result.push_back(node.combine(1.0, from[i], far, move[i]));
        return result;
    };
    Outputs p = node.point();
    for (double k = 0.0; k < steps; ++k) p = moved(p, reach, moved(p, 0.5 * reach, p));
    return p;
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
    a_node("simplex_nd", NodeResult::number, simplex_nd,
           "simplex noise of 2 to 8 dimensions with a signal of choice; x4 to x8 are the same in "
           "every octave",
           "Perlin 2001",
           {a_number("x4", "fourth coordinate", "0"), a_number("x5", "fifth coordinate", "0"),
            a_number("x6", "sixth coordinate", "0"), a_number("x7", "seventh coordinate", "0")},
           {whole("dimensions", 2, 8, "5", "how many coordinates count"),
            one_of("signal", "\"gradient\"", "gradient|value|wave",
                   "about each corner: a random ramp, a random number, a random plane wave"),
            real("waves", 0.05, 64, "2", "periods of a wave per cell"), seed_parameter,
            octaves_parameter("1"), lacunarity_parameter, gain_parameter,
            real("x8", -1e9, 1e9, "0", "eighth coordinate")}),
    a_node("fibre", NodeResult::number, fibre,
           "fbm of cells stretched along a direction: wood fibres, brushed metal", own, {},
           {several("direction", 3, "[0,0,1]", "along which the fibres run"),
            real("length", 1e-6, 1e6, "1", "of a cell along the fibres"),
            real("width", 1e-6, 1e6, "0.05", "of a cell across the fibres"),
            real("wave", -1e6, 1e6, "0", "how far fibres stray sideways, over `length`"),
            kind_parameter, seed_parameter, octaves_parameter("4"), lacunarity_parameter,
            gain_parameter, time_parameter}),
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
    a_node(
        "curl", NodeResult::inner, curl,
        "the point after a walk along a random field that keeps volumes: swirls and veins",
        "Bridson et al. 2007", moved_input,
        {real("strength", -1e6, 1e6, "0.25",
              "length of the walk where the field has its mean square length"),
         real("scale", 1e-6, 1e6, "1", "factor of the point"),
         whole("steps", 1, 16, "4", "of the walk, two samples of the field each"), seed_parameter,
         octaves_parameter("1"), lacunarity_parameter, gain_parameter, time_parameter}),
};

}  // namespace

std::span<const NodeType> noises() {
    return noise_rows;
}

}  // namespace burl::nodes
