#include "procedural/model/texture.h"

#include <algorithm>

#include "procedural/model/octaves.h"
#include "procedural/noise/noise.h"

namespace burl {

namespace {

/// The map F s + phase of a term, for its first octave.
Affine3 first_octave_map(const NoiseTerm& term) {
    Affine3 map;
    if (!term.matrix) {
        map.linear = Mat3d(0.0);
        for (int axis = 0; axis < 3; ++axis) map.linear[axis][axis] = term.frequency[axis];
        map.offset = term.phase;
        return map;
    }
    for (int row = 0; row < 3; ++row) {
        const double* m = term.matrix->data() + 4 * row;
        for (int column = 0; column < 3; ++column) map.linear[column][row] = m[column];
        map.offset[row] = m[3];
    }
    return map;
}

/// The range of a term that gives none: the unit range for noise that is not negative by itself and
/// for value noise, the signed range for the others.
NoiseRange natural_range(const NoiseTerm& term) {
    const bool positive = is_distance(term.kind) || term.shape != OctaveShape::plain;
    return positive || term.kind == NoiseKind::value ? NoiseRange::unit : NoiseRange::bipolar;
}

/// An octave with amplitude `a` of a term, without its noise.
Octave scaled_octave(const NoiseTerm& term, double a) {
    const bool unit = term.range.value_or(natural_range(term)) == NoiseRange::unit;
    const bool positive = is_distance(term.kind) || term.shape != OctaveShape::plain;
    Octave octave;
    octave.shape = term.shape;
    if (positive) {
        octave.scale = unit ? a : 2.0 * a;
        octave.offset = unit ? 0.0 : -a;
    } else {
        octave.scale = unit ? 0.5 * a : a;
        octave.offset = unit ? 0.5 * a : 0.0;
    }
    return octave;
}

/// The period of an octave in its own cells.
Period<4> octave_period(const NoiseTerm& term, double frequency) {
    Period<4> period{0, 0, 0, term.time_period};
    for (std::size_t axis = 0; axis < 3; ++axis)
        period[axis] =
            std::uint32_t(std::min(term.period[axis] * frequency, double(largest_period)));
    return period;
}

/// Appends a term's octaves whose amplitude is zero (`idle`) or those whose amplitude is not.
void append_octaves(const NoiseTerm& term, bool idle, std::vector<Octave>& octaves) {
    const Affine3 first = first_octave_map(term);
    double amplitude = term.amplitude, frequency = 1.0;
    if (term.normalized) amplitude /= octave_weights(term.gain, term.octaves);
    for (std::uint32_t k = 0; k < term.octaves; ++k) {
        if ((amplitude == 0.0) == idle) {
            Octave octave = scaled_octave(term, amplitude);
            octave.noise = {term.kind,    term.fade,     term.feature,
                            term.radius2, term.seed + k, octave_period(term, frequency),
                            term.time};
            octave.lattice_from_solid = {frequency * first.linear, first.offset};
            octaves.push_back(octave);
        }
        amplitude *= term.gain;
        frequency *= term.lacunarity;
    }
}

}  // namespace

std::vector<Octave> expand_octaves(const Texture& texture) {
    std::vector<Octave> octaves;
    for (const NoiseTerm& term : texture.noise) append_octaves(term, false, octaves);
    return octaves;
}

std::vector<Octave> idle_octaves(const Texture& texture) {
    std::vector<Octave> octaves;
    for (const NoiseTerm& term : texture.noise) append_octaves(term, true, octaves);
    return octaves;
}

double evaluate_quadric(const Quadric& q, const Vec3d& s) {
    return glm::dot(s, half_gradient(q, s)) + (q.d * s.x + q.g * s.y + q.i * s.z) + q.j;
}

Vec3d half_gradient(const Quadric& q, const Vec3d& s) {
    return {q.a * s.x + q.b * s.y + q.c * s.z + q.d, q.b * s.x + q.e * s.y + q.f * s.z + q.g,
            q.c * s.x + q.f * s.y + q.h * s.z + q.i};
}

Vec3d half_gradient_change(const Quadric& q, const Vec3d& step) {
    return {q.a * step.x + q.b * step.y + q.c * step.z, q.b * step.x + q.e * step.y + q.f * step.z,
            q.c * step.x + q.f * step.y + q.h * step.z};
}

double evaluate_field(const Quadric& quadric, std::span<const Octave> octaves, const Vec3d& s) {
    double f = evaluate_quadric(quadric, s);
    for (const Octave& octave : octaves) {
        const double n = evaluate_noise(octave.noise, octave.lattice_from_solid(s));
        f += octave.offset + octave.scale * shaped(octave.shape, n);
    }
    return f;
}

template <class Real>
FieldSample sample_field(const Quadric& quadric, std::span<const Octave> octaves, const Vec3d& s) {
    FieldSample f{evaluate_quadric(quadric, s), 2.0 * half_gradient(quadric, s)};
    for (const Octave& octave : octaves) {
        const Vec3d p = octave.lattice_from_solid(s);
        const auto n = shaped(octave.shape, sample_noise<Real, 3>(octave.noise, {p.x, p.y, p.z}));
        f.value += octave.offset + octave.scale * double(n.value);
        // The transposed map takes gradients back to the solid, eq. (12).
        f.gradient += octave.scale * (Vec3d(n.gradient[0], n.gradient[1], n.gradient[2]) *
                                      octave.lattice_from_solid.linear);
    }
    return f;
}

template FieldSample sample_field<float>(const Quadric&, std::span<const Octave>, const Vec3d&);
template FieldSample sample_field<double>(const Quadric&, std::span<const Octave>, const Vec3d&);

double evaluate_field(const Texture& texture, const Vec3d& s) {
    return evaluate_field(texture.quadric, expand_octaves(texture), s);
}

}  // namespace burl
