#pragma once
// The noise sum of a texture as the flat list of the octaves that are added: sum_i a_i n_i(T_i s)
// of eq. (1), without octaves of amplitude zero.
#include <span>
#include <vector>

#include "procedural/model/texture.h"
#include "procedural/noise/noise.h"

namespace burl {

/// An octave: offset + scale * shape(n(lattice_from_solid(s))), n as sample_noise gives it.
struct Octave {
    NoiseSpec noise;
    OctaveShape shape = OctaveShape::plain;
    double scale = 0.0;
    double offset = 0.0;  ///< constant that the range `unit` or `signed` adds
    Affine3 lattice_from_solid;
};

/// The octaves of all terms with a non-zero amplitude, in the order they are added.
std::vector<Octave> expand_octaves(const Texture& texture);
/// The octaves with an amplitude of zero, which expand_octaves leaves out.
std::vector<Octave> idle_octaves(const Texture& texture);

/// f(s) in float64 from octaves that were expanded before, for the evaluation at many points.
double evaluate_field(const Quadric& quadric, std::span<const Octave> octaves, const Vec3d& s);

/// f and its gradient with respect to s.
struct FieldSample {
    double value = 0.0;
    Vec3d gradient{0.0};
};

/// f(s) with its gradient, eq. (10) to (12): q in float64, the noise in Real (float, as bakes
/// evaluate it, or double), the sum in float64.
template <class Real>
FieldSample sample_field(const Quadric& quadric, std::span<const Octave> octaves, const Vec3d& s);

/// q(s), eq. (3).
double evaluate_quadric(const Quadric& q, const Vec3d& s);

/// Half the gradient of q at s: Q s without its last row, eq. (11).
Vec3d half_gradient(const Quadric& q, const Vec3d& s);

/// The change of half_gradient along a step, computed without the linear coefficients, whose size
/// would drown the change of a short step.
Vec3d half_gradient_change(const Quadric& q, const Vec3d& step);

}  // namespace burl
