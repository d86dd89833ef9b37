#pragma once
// Sums of one noise at rising frequencies: 1/f noise and Perlin's turbulence, the sum of 1/f |n|
// (Perlin 1985 and 2001), and ridges, the sum of 1/f (1 - |n|)^2 in the spirit of Musgrave
// ("Texturing and Modeling", without his feedback between octaves).
#include <cmath>

#include "procedural/noise/lattice_site.h"

namespace burl {

enum class OctaveShape { plain, absolute, ridged };

/// A sum of octaves: octave k has frequency lacunarity^k and amplitude gain^k.
struct FractalSum {
    OctaveShape shape = OctaveShape::plain;
    std::uint32_t octaves = 1;
    double lacunarity = 2.0, gain = 0.5;
    bool normalized = false;  ///< divides by octave_weights: the range of one octave
    bool operator==(const FractalSum&) const = default;
};

/// sum_{k<octaves} |gain|^k, by which a normalised sum is divided.
inline double octave_weights(double gain, std::uint32_t octaves) {
    double sum = 0.0, weight = 1.0;
    for (std::uint32_t k = 0; k < octaves; ++k, weight *= std::abs(gain)) sum += weight;
    return sum;
}

/// The shaped noise: n, |n| or (1 - |n|)^2.
template <class Real>
Real shaped(OctaveShape shape, Real n) {
    if (shape == OctaveShape::plain) return n;
    const Real size = std::abs(n);
    return shape == OctaveShape::absolute ? size : (Real(1) - size) * (Real(1) - size);
}

/// The shaped noise with its gradient; at n = 0, where |n| has a kink, the slope is 0.
template <class Real, std::size_t N>
NoiseSample<Real, N> shaped(OctaveShape shape, NoiseSample<Real, N> n) {
    if (shape == OctaveShape::plain) return n;
    Real slope = Real(n.value > 0) - Real(n.value < 0);
    if (shape == OctaveShape::ridged) slope *= Real(-2) * (Real(1) - std::abs(n.value));
    n.value = shaped(shape, n.value);
    for (Real& x : n.gradient) x *= slope;
    return n;
}

/// sum_k gain^k shape(noise(k, lacunarity^k p)), where noise(k, p) is the noise of octave k. The
/// float32 error is at most the sum of the octaves' errors plus 1.2e-7 times the sum of their
/// sizes.
template <class Real, std::size_t N, class Noise>
NoiseSample<Real, N> fractal_sum(const FractalSum& fractal, const Point<N>& p, Noise&& noise) {
    NoiseSample<Real, N> sum;
    double frequency = 1.0;
    double weight = fractal.normalized ? 1.0 / octave_weights(fractal.gain, fractal.octaves) : 1.0;
    for (std::uint32_t k = 0; k < fractal.octaves; ++k) {
        Point<N> q;
        for (std::size_t axis = 0; axis < N; ++axis) q[axis] = frequency * p[axis];
        const NoiseSample<Real, N> n = shaped(fractal.shape, noise(k, q));
        sum.value += Real(weight) * n.value;
        for (std::size_t axis = 0; axis < N; ++axis)
            sum.gradient[axis] += Real(weight * frequency) * n.gradient[axis];
        weight *= fractal.gain;
        frequency *= fractal.lacunarity;
    }
    return sum;
}

}  // namespace burl
