// The steps of noise with gradients, as graph/dual_noise.cpp evaluates them in float32.
#include <fmt/format.h>

#include "procedural/field/lattice_sums.h"
#include "procedural/glsl/duals.h"
#include "procedural/glsl/simplex.h"
#include "procedural/model/band_limit.h"

namespace burl {

GlslDuals::Names GlslDuals::step(const OctaveSum& octaves) {
    Names p = inputs_;
    if (octaves.scale != 1.0)
        for (std::string& x : p) x = dual(fmt::format("{} * {}", number(octaves.scale), x));
    const NoiseSum all = octaves.sum();
    std::string kept;
    if (filter_ && octaves.fades)
        kept = variable(
            "float",
            fmt::format("float(visible_octaves({}, {}, {}, step_u, step_v, {}, {}))", p[0], p[1],
                        p[2], number(std::log2(octaves.lacunarity)), number(octaves.octaves)));
    const GlslSum written = sums_.slopes(all, {p[0] + ".x", p[1] + ".x", p[2] + ".x"}, kept,
                                         octaves.mean(), new_name("n"));
    lines_ += written.lines;
    return {dual(fmt::format("dual_at({}, {}, {}, {})", written.result, p[0], p[1], p[2]))};
}

std::array<std::string, 2> GlslDuals::steps() const {
    if (!filter_) return {"real3(0.0)", "real3(0.0)"};
    return {"step_u", "step_v"};
}

GlslDuals::Names GlslDuals::step(const SimplexOctaves& octaves) {
    return {dual(glsl_dual_simplex_sum(octaves, inputs_, steps(), functions_))};
}

GlslDuals::Names GlslDuals::step(const CurlOctaves& octaves) {
    const std::string field =
        variable("DualVector", glsl_dual_curl_sum(octaves, inputs_, steps(), functions_));
    return {field + ".x", field + ".y", field + ".z"};
}

GlslDuals::Names GlslDuals::step(const DotsWeight& dots) {
    const std::string radius = number(dots.radius);
    const std::string disk =
        variable("DotDisk", fmt::format("dot_disk({}.x, {}.x, {}u, uvec2({}u, {}u), {})", in(0),
                                        in(1), dots.seed, dots.period_u, dots.period_v, radius));
    const std::string inside =
        dual(fmt::format("dot_inside({}, {}, {}, {})", in(0), in(1), disk, radius));
    return {dual(fmt::format("{}.there ? box_step({}, {}) : {}", disk, inside, box_width(inside),
                             constant(0.0)))};
}

/// The name of a variable with the point in an octave's lattice.
std::string GlslDuals::at_lattice(const Affine3& lattice) {
    const Mat3d rows = glm::transpose(lattice.linear);
    std::array<std::string, 3> sums;
    for (int i = 0; i < 3; ++i) {
        std::vector<double> factors;
        std::vector<std::string> terms;
        for (int k = 0; k < 3; ++k) {
            if (rows[i][k] == 0.0) continue;
            factors.push_back(rows[i][k]);
            terms.push_back(in(std::size_t(k)) + ".x");
        }
        sums[std::size_t(i)] = glsl_sum(factors, terms, lattice.offset[i], functions_.real());
    }
    return variable("exact real3", fmt::format("real3({}, {}, {})", sums[0], sums[1], sums[2]));
}

/// The name of a variable with a sum of octaves and its derivatives at a point of type real3.
std::string GlslDuals::lattice_octaves(const NoiseSum& sum, const std::string& point) {
    const GlslSum written =
        sums_.slopes(sum, {point + ".x", point + ".y", point + ".z"}, "", 0.0, new_name("n"));
    lines_ += written.lines;
    return variable("vec4", written.result);
}

/// The gradient in the vec4 `noise` with respect to lattice coordinates, transformed to the point.
std::string GlslDuals::point_gradient(const std::string& noise, const Mat3d& lattice) const {
    return fmt::format("lattice_gradient({}, {}, {}, {})", noise, real3(lattice[0]),
                       real3(lattice[1]), real3(lattice[2]));
}

/// Writes the lines that add all octaves.
void GlslDuals::add_octaves(std::span<const Octave> octaves, const Field& f) {
    for (const LatticeSum& part : lattice_sums(octaves)) {
        const std::string n = lattice_octaves(part.sum, at_lattice(part.lattice));
        line(fmt::format("{0} = {0} + real({1}.x);", f.value, n));
        line(fmt::format("{0} = {0} + {1};", f.gradient, point_gradient(n, part.lattice.linear)));
    }
}

/// The change of the point along a step of the footprint, through a linear map.
std::string GlslDuals::moved_by(const Mat3d& linear, char step) const {
    const Mat3d rows = glm::transpose(linear);
    return fmt::format("half_gradient({}, {}, {}, real3(0.0), real3({}, {}, {}))", real3(rows[0]),
                       real3(rows[1]), real3(rows[2]), along(in(0), step), along(in(1), step),
                       along(in(2), step));
}

/// Writes the lines that add the octaves as far as the footprint shows them; their means replace
/// the rest. (The host evaluates these octaves in float64.)
void GlslDuals::add_faded_octaves(std::span<const Octave> octaves, const Field& f) {
    for (const Octave& octave : octaves) {
        const Mat3d& linear = octave.lattice_from_solid.linear;
        const std::string share = variable(
            "exact real",
            fmt::format("band_weight({}, {})", moved_by(linear, 'u'), moved_by(linear, 'v')));
        NoiseSum lone{octave.noise, octave.shape, {{octave.noise.seed, 1.0, 1.0}}, 0.0};
        lone.noise.seed = 0;
        const std::string n = lattice_octaves(lone, at_lattice(octave.lattice_from_solid));
        const std::string scale = glsl_operand(number(octave.scale)),
                          mean = glsl_operand(number(octave_mean(octave)));
        line(fmt::format("{0} = {0} + ({1} * {2} * real({3}.x) + ({4} - {1}) * {5});", f.value,
                         share, scale, n, number(1.0), mean));
        line(fmt::format("{0} = {0} + {1} * {2} * {3};", f.gradient, share, scale,
                         point_gradient(n, linear)));
    }
}

/// The expression of the quadric at the point; writes a line that adds its gradient to the field's.
std::string GlslDuals::quadric(const Quadric& q, const Field& f) {
    if (q == Quadric{}) return number(0.0);
    const std::string at =
        variable("exact real3", fmt::format("real3({}.x, {}.x, {}.x)", in(0), in(1), in(2)));
    const std::string linear = real3({q.d, q.g, q.i});
    const std::string half = variable(
        "exact real3", fmt::format("half_gradient({}, {}, {}, {}, {})", real3({q.a, q.b, q.c}),
                                   real3({q.b, q.e, q.f}), real3({q.c, q.f, q.h}), linear, at));
    line(fmt::format("{0} = {0} + {1} * {2};", f.gradient, number(2.0), half));
    return fmt::format("dot_of({0}, {1}) + dot_of({2}, {0}) + {3}", at, half, linear,
                       glsl_operand(number(q.j)));
}

GlslDuals::Names GlslDuals::step(const FieldAt& field) {
    const std::vector<Octave> octaves = expand_octaves(*field.texture);
    const Field f{variable("exact real", number(0.0)), variable("exact real3", "real3(0.0)")};
    if (filter_ && filter_->band_limit)
        add_faded_octaves(octaves, f);
    else
        add_octaves(octaves, f);
    double offsets = 0.0;
    for (const Octave& octave : octaves) offsets += octave.offset;
    line(fmt::format("{0} = {0} + ({1} + {2});", f.value, quadric(field.texture->quadric, f),
                     glsl_operand(number(offsets))));
    return {
        dual(fmt::format("dual_at({}, {}, {}, {}, {})", f.value, f.gradient, in(0), in(1), in(2)))};
}

}  // namespace burl
