// The nodes of irregular textures with their gradients, as graph/noise.cpp defines them in float32.
#include <fmt/format.h>

#include "procedural/field/lattice_sums.h"
#include "procedural/glsl/duals.h"
#include "procedural/graph/node_noise.h"
#include "procedural/model/band_limit.h"
#include "procedural/noise/mean_noise.h"

namespace burl {

namespace {

/// The sum sum_k gain^k shape(n_{seed+k}(lacunarity^k p)) and its fade.
struct OctaveSum {
    NoiseSum sum;
    GlslFade fade{};
};

OctaveSum octave_sum(const GlslNodeCall& call, OctaveShape shape, double octaves) {
    const double gain = call.parameter("gain");
    const NoiseSpec noise = noise_of(call);
    const bool timed = noise.time.has_value();
    OctaveSum result{{noise, shape, {}, 0.0}};
    result.fade.mean = shape == OctaveShape::absolute ? mean_absolute(noise.kind, timed)
                                                      : mean_value(noise.kind, timed);
    result.fade.lacunarity = call.parameter("lacunarity");
    double frequency = 1.0, weight = 1.0;
    for (double k = 0.0; k < octaves; ++k) {
        result.sum.octaves.push_back({noise.seed + std::uint32_t(k), frequency, weight});
        weight *= gain;
        frequency *= result.fade.lacunarity;
    }
    result.sum.noise.seed = 0;
    return result;
}

/// The node's point times `factors`, coordinate by coordinate.
std::array<std::string, 3> scaled(const GlslNodeCall& call, const Vec3d& factors) {
    std::array<std::string, 3> point = call.point();
    for (std::size_t i = 0; i < 3; ++i) {
        const double factor = factors[int(i)];
        if (factor != 1.0)
            point[i] = call.text->dual(
                fmt::format("{} * {}", glsl_operand(call.text->number(factor)), point[i]));
    }
    return point;
}

std::string sum_at(const GlslNodeCall& call, const OctaveSum& octaves,
                   const Vec3d& factors = Vec3d(1.0)) {
    return call.text->octaves(octaves.sum, scaled(call, factors), octaves.fade);
}

GlslNode fractal(const GlslNodeCall& call, OctaveShape shape) {
    return {{sum_at(call, octave_sum(call, shape, call.parameter("octaves")))}};
}

GlslNode fbm(const GlslNodeCall& call) {
    return fractal(call, OctaveShape::plain);
}

GlslNode wrinkled(const GlslNodeCall& call) {
    return fractal(call, OctaveShape::absolute);
}

GlslNode windy(const GlslNodeCall& call) {
    const std::string waves =
        sum_at(call, octave_sum(call, OctaveShape::plain, call.parameter("octaves")));
    const std::string wind = sum_at(call, octave_sum(call, OctaveShape::plain, 3.0), Vec3d(0.1));
    return call.number(fmt::format("dual_product(dual_abs({}), {})", wind, waves));
}

GlslNode bumps(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const OctaveSum octave = octave_sum(call, OctaveShape::plain, 1.0);
    const std::string n = text.octaves(octave.sum, scaled(call, call.vector("frequency")), {});
    const std::string threshold = text.constant(call.parameter("threshold"));
    const std::string above = text.dual(is_distance(octave.sum.noise.kind)
                                            ? fmt::format("{} - {}", n, threshold)
                                            : fmt::format("({} + {} * {}) - {}", text.constant(0.5),
                                                          text.number(0.5), n, threshold));
    return call.blend(fmt::format("box_step({}, {})", above, text.box_width(above)));
}

GlslNode dots(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const auto whole = [&](const char* key) { return std::uint32_t(call.parameter(key)); };
    const std::string radius = text.number(call.parameter("radius"));
    const std::string disk =
        text.variable("DotDisk", fmt::format("dot_disk({}.x, {}.x, {}u, uvec2({}u, {}u), {})",
                                             call.axis(0), call.axis(1), whole("seed"),
                                             whole("period_u"), whole("period_v"), radius));
    const std::string inside = text.dual(
        fmt::format("dot_inside({}, {}, {}, {})", call.axis(0), call.axis(1), disk, radius));
    return call.blend(fmt::format("{}.there ? box_step({}, {}) : {}", disk, inside,
                                  text.box_width(inside), text.constant(0.0)));
}

GlslNode warp(const GlslNodeCall& call) {
    const OctaveSum octaves = octave_sum(call, OctaveShape::plain, call.parameter("octaves"));
    const std::string strength = glsl_operand(call.text->number(call.parameter("strength")));
    GlslNode result;
    for (std::size_t i = 0; i < 3; ++i) {
        OctaveSum move = octaves;
        for (SumOctave& octave : move.sum.octaves) octave.seed += std::uint32_t(i) << 16;
        const std::string moved = sum_at(call, move);
        result.channels.push_back(
            call.text->dual(fmt::format("{} + {} * {}", call.axis(i), strength, moved)));
    }
    return result;
}

/// The text "real3(...)" of the node's point in a lattice.
std::string lattice_point(const GlslNodeCall& call, const Affine3& lattice) {
    const Mat3d rows = glm::transpose(lattice.linear);
    std::array<std::string, 3> sums;
    for (int i = 0; i < 3; ++i) {
        std::vector<double> factors;
        std::vector<std::string> terms;
        for (int k = 0; k < 3; ++k) {
            if (rows[i][k] == 0.0) continue;
            factors.push_back(rows[i][k]);
            terms.push_back(call.axis(std::size_t(k)) + ".x");
        }
        sums[std::size_t(i)] =
            glsl_sum(factors, terms, lattice.offset[i], call.text->functions().real());
    }
    return fmt::format("real3({}, {}, {})", sums[0], sums[1], sums[2]);
}

/// The text "real3(x, y, z)" of a constant vector.
std::string real3(const GlslDuals& text, const Vec3d& v) {
    return fmt::format("real3({}, {}, {})", text.number(v.x), text.number(v.y), text.number(v.z));
}

/// The expression of the quadric at the point; writes a line that adds its gradient to the variable
/// `gradient`.
std::string quadric_at(const GlslNodeCall& call, const Quadric& q, const std::string& gradient) {
    GlslDuals& text = *call.text;
    if (q == Quadric{}) return text.number(0.0);
    const std::string at = text.variable(
        "exact real3",
        fmt::format("real3({}.x, {}.x, {}.x)", call.axis(0), call.axis(1), call.axis(2)));
    const std::string linear = real3(text, {q.d, q.g, q.i});
    const std::string half = text.variable(
        "exact real3",
        fmt::format("half_gradient({}, {}, {}, {}, {})", real3(text, {q.a, q.b, q.c}),
                    real3(text, {q.b, q.e, q.f}), real3(text, {q.c, q.f, q.h}), linear, at));
    text.line(fmt::format("{0} = {0} + {1} * {2};", gradient, text.number(2.0), half));
    return fmt::format("dot_of({0}, {1}) + dot_of({2}, {0}) + {3}", at, half, linear,
                       glsl_operand(text.number(q.j)));
}

/// The name of a variable with the point in an octave's lattice.
std::string lattice_variable(const GlslNodeCall& call, const Affine3& lattice) {
    return call.text->variable("exact real3", lattice_point(call, lattice));
}

/// The gradient in the vec4 `n` with respect to lattice coordinates, transformed to the node's
/// point.
std::string point_gradient(const GlslDuals& text, const std::string& n, const Mat3d& m) {
    return fmt::format("lattice_gradient({}, {}, {}, {})", n, real3(text, m[0]), real3(text, m[1]),
                       real3(text, m[2]));
}

/// The names of variables of a field's value and its gradient with respect to the node's point.
struct FieldText {
    std::string value, gradient;
};

/// Writes the lines that add all octaves.
void add_octaves(const GlslNodeCall& call, std::span<const Octave> octaves, const FieldText& f) {
    GlslDuals& text = *call.text;
    for (const LatticeSum& part : lattice_sums(octaves)) {
        const std::string at = lattice_variable(call, part.lattice);
        const std::string n = text.variable("vec4", text.lattice_octaves(part.sum, at));
        text.line(fmt::format("{0} = {0} + real({1}.x);", f.value, n));
        text.line(fmt::format("{0} = {0} + {1};", f.gradient,
                              point_gradient(text, n, part.lattice.linear)));
    }
}

/// The change of the point along a step of the footprint, through a linear map.
std::string moved_by(const GlslNodeCall& call, const Mat3d& linear, char step) {
    const Mat3d rows = glm::transpose(linear);
    const std::string by =
        fmt::format("real3({}, {}, {})", call.text->along(call.axis(0), step),
                    call.text->along(call.axis(1), step), call.text->along(call.axis(2), step));
    return fmt::format("half_gradient({}, {}, {}, real3(0.0), {})", real3(*call.text, rows[0]),
                       real3(*call.text, rows[1]), real3(*call.text, rows[2]), by);
}

/// Writes the lines that add the octaves as far as the footprint shows them; their means replace
/// the rest. (The host evaluates these octaves in float64.)
void add_faded_octaves(const GlslNodeCall& call, std::span<const Octave> octaves,
                       const FieldText& f) {
    GlslDuals& text = *call.text;
    for (const Octave& octave : octaves) {
        const Mat3d& linear = octave.lattice_from_solid.linear;
        const std::string share = text.real(fmt::format(
            "band_weight({}, {})", moved_by(call, linear, 'u'), moved_by(call, linear, 'v')));
        NoiseSum sum{octave.noise, octave.shape, {{octave.noise.seed, 1.0, 1.0}}, 0.0};
        sum.noise.seed = 0;
        const std::string at = lattice_variable(call, octave.lattice_from_solid);
        const std::string n = text.variable("vec4", text.lattice_octaves(sum, at));
        const std::string scale = glsl_operand(text.number(octave.scale)),
                          mean = glsl_operand(text.number(octave_mean(octave)));
        text.line(fmt::format("{0} = {0} + ({1} * {2} * real({3}.x) + ({4} - {1}) * {5});", f.value,
                              share, scale, n, text.number(1.0), mean));
        text.line(fmt::format("{0} = {0} + {1} * {2} * {3};", f.gradient, share, scale,
                              point_gradient(text, n, linear)));
    }
}

GlslNode field(const GlslNodeCall& call) {
    GlslDuals& text = *call.text;
    const Texture& texture = call.graph->textures[call.node->texture];
    const std::vector<Octave> octaves = expand_octaves(texture);
    const FieldText f{text.real(text.number(0.0)), text.variable("exact real3", "real3(0.0)")};
    if (text.filtering() && text.filtering()->filter.band_limit)
        add_faded_octaves(call, octaves, f);
    else
        add_octaves(call, octaves, f);
    double offsets = 0.0;
    for (const Octave& octave : octaves) offsets += octave.offset;
    const std::string quadric = quadric_at(call, texture.quadric, f.gradient);
    text.line(fmt::format("{0} = {0} + ({1} + {2});", f.value, quadric,
                          glsl_operand(text.number(offsets))));
    return call.number(fmt::format("dual_at({}, {}, {}, {}, {})", f.value, f.gradient, call.axis(0),
                                   call.axis(1), call.axis(2)));
}

constexpr std::array noise_table{NamedGlslNode{"field", field},       NamedGlslNode{"fbm", fbm},
                                 NamedGlslNode{"wrinkled", wrinkled}, NamedGlslNode{"windy", windy},
                                 NamedGlslNode{"bumps", bumps},       NamedGlslNode{"dots", dots},
                                 NamedGlslNode{"warp", warp}};

}  // namespace

std::span<const NamedGlslNode> glsl_noise_nodes() {
    return noise_table;
}

std::string glsl_octaves_at(const GlslNodeCall& call, const Vec3d& factors) {
    return sum_at(call, octave_sum(call, OctaveShape::plain, call.parameter("octaves")), factors);
}

}  // namespace burl
