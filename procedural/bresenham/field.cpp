#include "procedural/bresenham/field.h"

#include <algorithm>
#include <vector>

#include "procedural/bresenham/cell_polynomial.h"
#include "procedural/bresenham/cell_walk.h"
#include "procedural/bresenham/differences.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

namespace {

/// An octave and the cell that the line is in.
struct OctaveWalk {
    OctaveWalk(const Octave& of, const LatticeLine& solid)
        : octave(&of), line(lattice_line(of.lattice_from_solid, solid)), walk(line) {
        enter();
    }
    void enter() {
        const Period<4>& period = octave->noise.period;
        blend =
            cell_blend(walk.stretch().cell, octave->noise.seed, {period[0], period[1], period[2]});
    }
    void advance() {
        walk.advance();
        enter();
    }
    Vec3d place(std::int64_t texel) const { return cell_place(line, walk.stretch().cell, texel); }
    double value(std::int64_t texel) const {
        return octave->scale * blend_at(blend, octave->noise.fade, place(texel));
    }

    const Octave* octave;
    LatticeLine line;
    CellWalk walk;
    CellBlend blend{};
};

/// The field along a line of solid points.
struct FieldLine {
    const Quadric& quadric;
    LatticeLine solid;
    double constant = 0.0;  ///< sum of the octaves' offsets
    std::vector<OctaveWalk> octaves;

    Vec3d point(std::int64_t texel) const { return solid.start + double(texel) * solid.step; }
};

/// The texels in which no octave changes its cell.
CellStretch common_stretch(const FieldLine& field) {
    CellStretch common{0, std::int64_t(1) << 62, {}};
    for (const OctaveWalk& octave : field.octaves) {
        common.first = std::max(common.first, octave.walk.stretch().first);
        common.last = std::min(common.last, octave.walk.stretch().last);
    }
    return common;
}

/// The field at a texel, evaluated without differences.
double direct_value(const FieldLine& field, std::int64_t texel) {
    double f = evaluate_quadric(field.quadric, field.point(texel)) + field.constant;
    for (const OctaveWalk& octave : field.octaves) f += octave.value(texel);
    return f;
}

template <std::size_t degree, Fade fade>
void add_octave(const OctaveWalk& octave, std::int64_t origin, Powers<degree>& f) {
    if constexpr (3 * fade_degree(fade) <= degree) {
        const auto n = noise_along<fade>(octave.blend, octave.place(origin), octave.line.step);
        for (std::size_t k = 0; k < n.size(); ++k) f[k] += octave.octave->scale * n[k];
    }
}

/// f at texel origin + j as a polynomial of j.
template <std::size_t degree>
Powers<degree> field_along(const FieldLine& field, std::int64_t origin) {
    const Vec3d s = field.point(origin), &step = field.solid.step;
    const Vec3d turn = half_gradient_change(field.quadric, step);
    Powers<degree> f{};
    f[0] = evaluate_quadric(field.quadric, s) + field.constant;
    f[1] = 2.0 * glm::dot(half_gradient(field.quadric, s), step);
    f[2] = glm::dot(step, turn);
    for (const OctaveWalk& octave : field.octaves) switch (octave.octave->noise.fade) {
            case Fade::linear:
                add_octave<degree, Fade::linear>(octave, origin, f);
                break;
            case Fade::smooth:
                add_octave<degree, Fade::smooth>(octave, origin, f);
                break;
            case Fade::quintic:
                add_octave<degree, Fade::quintic>(octave, origin, f);
                break;
        }
    return f;
}

/// A bound of |f| on the `texels` texels from `origin` on: value noise is at most 1.
double largest_value(const FieldLine& field, std::int64_t origin, double texels) {
    const Vec3d s = field.point(origin), &step = field.solid.step;
    const Vec3d turn = half_gradient_change(field.quadric, step);
    double largest = std::abs(evaluate_quadric(field.quadric, s)) + std::abs(field.constant) +
                     texels * (2.0 * std::abs(glm::dot(half_gradient(field.quadric, s), step)) +
                               texels * std::abs(glm::dot(step, turn)));
    for (const OctaveWalk& octave : field.octaves) largest += std::abs(octave.octave->scale);
    return largest;
}

/// The number of fraction bits with which neither a value nor a first difference overflows.
template <std::size_t degree>
int fitting_bits(double largest, const Powers<degree>& differences) {
    for (const double d : differences) largest = std::max(largest, std::abs(d));
    return 61 - std::clamp(std::ilogb(largest), -900, 900);
}

template <class Number, std::size_t degree>
ForwardCounts fill_line(FieldLine& field, std::int64_t longest, double* values) {
    const auto begin = std::int64_t(field.solid.first);
    const std::int64_t end = begin + std::int64_t(field.solid.count);
    ForwardCounts counts;
    counts.cells = std::int64_t(field.octaves.size());
    for (CellStretch at = common_stretch(field); at.first < end; at = common_stretch(field)) {
        const CellSpan texels{at.first, at.last, begin, end};
        if (std::min(longest, at.last - at.first) <= std::int64_t(degree)) {
            for (std::int64_t j = texels.wanted_first(); j < texels.wanted_last(); ++j)
                values[j - begin] = direct_value(field, j);
            counts.direct += texels.wanted_last() - texels.wanted_first();
        } else {
            counts.runs += for_each_run(texels, longest, [&](std::int64_t origin, std::int64_t to) {
                const Powers<degree> differences =
                    differences_at_zero(field_along<degree>(field, origin));
                int bits = 0;
                if constexpr (std::integral<Number>)
                    bits = fitting_bits<degree>(
                        largest_value(field, origin, double(std::min(longest, at.last - origin))),
                        differences);
                ForwardDifferences<Number, degree> f(differences, bits);
                run_differences(f, origin, to, begin,
                                [&](std::int64_t j, double value) { values[j - begin] = value; });
            });
        }
        if (at.last >= end) break;
        for (OctaveWalk& octave : field.octaves) {
            if (octave.walk.stretch().last != at.last) continue;
            octave.advance();
            ++counts.cells;
        }
    }
    return counts;
}

template <std::size_t degree>
ForwardCounts fill_line(FieldLine& field, const ForwardOptions& options, double* values) {
    double fastest = 0.0;
    for (const OctaveWalk& octave : field.octaves)
        fastest = std::max(fastest, fastest_step(octave.line));
    const std::int64_t longest = options.longest_run > 0
                                     ? options.longest_run
                                     : longest_run(degree, options.precision, fastest);
    switch (options.precision) {
        case ForwardPrecision::float32:
            return fill_line<float, degree>(field, longest, values);
        case ForwardPrecision::float64:
            return fill_line<double, degree>(field, longest, values);
        case ForwardPrecision::fixed64:
            return fill_line<std::int64_t, degree>(field, longest, values);
    }
    return {};
}

}  // namespace

std::string no_forward_form(std::span<const Octave> octaves) {
    for (const Octave& octave : octaves) {
        std::string why = no_forward_form(octave.noise);
        if (!why.empty()) return why;
        if (octave.shape != OctaveShape::plain) return "|n| is no polynomial where n changes sign";
    }
    return {};
}

ForwardCounts forward_field(const Quadric& quadric, std::span<const Octave> octaves,
                            const LatticeLine& solid, const ForwardOptions& options,
                            double* values) {
    if (solid.count == 0) return {};
    FieldLine field{quadric, solid, 0.0, {}};
    std::size_t degree = 3;
    for (const Octave& octave : octaves) {
        field.octaves.emplace_back(octave, solid);
        field.constant += octave.offset;
        degree = std::max(degree, 3 * fade_degree(octave.noise.fade));
    }
    if (degree == 3) return fill_line<3>(field, options, values);
    if (degree == 9) return fill_line<9>(field, options, values);
    return fill_line<15>(field, options, values);
}

ForwardCounts forward_octaves(const Quadric& quadric, std::span<const Octave> octaves,
                              const LatticeLine& solid, const ForwardOptions& options,
                              double* values) {
    Quadric shifted = quadric;
    for (const Octave& octave : octaves) shifted.j += octave.offset;
    ForwardCounts counts = forward_field(shifted, {}, solid, options, values);
    for (const Octave& octave : octaves)
        counts +=
            add_forward_noise(octave.noise, octave.scale,
                              lattice_line(octave.lattice_from_solid, solid), options, values);
    return counts;
}

ForwardCounts forward_values(const Quadric& quadric, std::span<const Octave> octaves,
                             const LatticeLine& solid, const ForwardOptions& options,
                             double* values) {
    double crossings = 0.0;
    for (const Octave& octave : octaves) {
        const Vec3d step = glm::abs(lattice_line(octave.lattice_from_solid, solid).step);
        crossings += step.x + step.y + step.z;
    }
    const bool whole = crossings <= whole_function_crossings;
    return (whole ? forward_field : forward_octaves)(quadric, octaves, solid, options, values);
}

}  // namespace burl
