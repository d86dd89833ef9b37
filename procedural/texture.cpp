#include "procedural/texture.h"

#include "procedural/noise.h"
#include "procedural/octaves.h"

namespace burl {

namespace {

/// F s + phase of a term, before any octave scales F.
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

void append_octaves(const NoiseTerm& term, std::vector<Octave>& octaves) {
    const NoiseRange natural =
        term.kind == NoiseKind::value ? NoiseRange::unit : NoiseRange::bipolar;
    const bool unit = term.range.value_or(natural) == NoiseRange::unit;
    const Affine3 first = first_octave_map(term);
    double amplitude = term.amplitude, frequency = 1.0;
    for (std::uint32_t k = 0; k < term.octaves; ++k) {
        if (amplitude != 0.0)
            octaves.push_back({term.kind, term.fade, term.seed + k,
                               unit ? 0.5 * amplitude : amplitude, unit ? 0.5 * amplitude : 0.0,
                               Affine3{frequency * first.linear, first.offset}});
        amplitude *= term.gain;
        frequency *= term.lacunarity;
    }
}

}  // namespace

std::vector<Octave> expand_octaves(const Texture& texture) {
    std::vector<Octave> octaves;
    for (const NoiseTerm& term : texture.noise) append_octaves(term, octaves);
    return octaves;
}

double evaluate_quadric(const Quadric& q, const Vec3d& s) {
    return glm::dot(s, half_gradient(q, s)) + (q.d * s.x + q.g * s.y + q.i * s.z) + q.j;
}

Vec3d half_gradient(const Quadric& q, const Vec3d& s) {
    return {q.a * s.x + q.b * s.y + q.c * s.z + q.d, q.b * s.x + q.e * s.y + q.f * s.z + q.g,
            q.c * s.x + q.f * s.y + q.h * s.z + q.i};
}

double evaluate_field(const Quadric& quadric, std::span<const Octave> octaves, const Vec3d& s) {
    double f = evaluate_quadric(quadric, s);
    for (const Octave& octave : octaves) {
        const Vec3d p = octave.lattice_from_solid(s);
        f +=
            octave.offset + octave.scale * evaluate_noise(octave.kind, octave.fade, octave.seed, p);
    }
    return f;
}

double evaluate_field(const Texture& texture, const Vec3d& s) {
    return evaluate_field(texture.quadric, expand_octaves(texture), s);
}

}  // namespace burl
