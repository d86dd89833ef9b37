#pragma once
// Simplex noise in two to eight dimensions with a signal of choice, after the sections "Spherical
// kernel" and "Generalization to higher dimensions" of Perlin's "Noise Hardware" (course notes,
// 2001), which leaves radius, amplitude and random numbers open and wants the signal separable from
// the kernels that reconstruct it. The sum over the corners of the point's simplex is t^4 s(d), d
// being the point less the corner and t = 1/2 - d . d: at squared radius 1/2 every kernel ends
// where the simplices round its corner do, in all dimensions, so that the noise is continuous with
// its first three derivatives.
#include <cstddef>
#include <cstdint>

#include "atlas/base/elementary.h"
#include "procedural/noise/simplex_noise.h"

namespace burl {

inline constexpr std::size_t least_simplex_dimensions = 2, most_simplex_dimensions = 8;

/// The signal that a corner's kernel multiplies: the ramp g . d, the constant v or the wave
/// sin(2 pi waves g . d), g being a random unit vector and v a random number in [-1, 1).
enum class SimplexSignal { gradient, value, wave };

/// The integral of (1/2 - d . d)^power over the kernel's ball, d . d <= 1/2.
inline double simplex_kernel_integral(std::size_t dimensions, int power) {
    double integral = std::ldexp(1.0, -power);
    if (dimensions % 2 == 1) {
        integral *= std::sqrt(2.0);
        for (int j = 1; j <= power; ++j) integral *= 2.0 * j / (2.0 * j + 1.0);
    }
    for (std::size_t n = dimensions % 2; n < dimensions; n += 2)
        integral *= 1.5707963267948966 / (0.5 * double(n) + power + 1.0);
    return integral;
}

/// A simplex noise of mean 0. Its standard deviation is 1/4 in every dimension for gradients and
/// values, and within 3 % of it for waves.
struct SimplexNoise {
    std::size_t dimensions = 3;  ///< 2 to 8
    SimplexSignal signal = SimplexSignal::gradient;
    double waves = 1.0;  ///< number of a wave's periods per unit
    bool operator==(const SimplexNoise&) const = default;

    /// The factor of a wave's g . d, in radians.
    double turn() const { return 2.0 * 3.141592653589793 * waves; }
    /// The mean of s^2 round a corner, weighted by t^8: that of (g . d)^2 is 1 / (2 n + 36). For
    /// waves g . d is taken as normally distributed.
    double mean_square() const {
        const double n = double(dimensions);
        if (signal == SimplexSignal::gradient) return 0.5 / (n + 18.0);
        if (signal == SimplexSignal::value) return 1.0 / 3.0;
        const double log2_e = 1.4426950408889634;
        return 0.5 - 0.5 * binary_power(-log2_e * turn() * turn() / (n + 18.0));
    }
    /// The factor of the sum of kernels. A unit of space has sqrt(n + 1) lattice points.
    double amplitude() const {
        const double kernels =
            std::sqrt(double(dimensions) + 1.0) * simplex_kernel_integral(dimensions, 8);
        return 0.25 / std::sqrt(kernels * mean_square());
    }
};

/// Random bits of a lattice point; from the fifth coordinate on, those of the first four are the
/// seed.
template <std::size_t N>
std::uint32_t simplex_bits(const std::array<std::int64_t, N>& corner, std::uint32_t seed) {
    std::array<std::uint32_t, (N < 4 ? N : 4)> first{};
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = std::uint32_t(corner[i]);
    const std::uint32_t h = LatticeHash::bits(first, seed);
    if constexpr (N > 4) {
        std::array<std::uint32_t, N - 4> rest{};
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = std::uint32_t(corner[4 + i]);
        return LatticeHash::bits(rest, h);
    }
    return h;
}

/// The size of the components of a random unit vector that are not 0: 1 / sqrt(n - 1).
inline constexpr std::array simplex_units{0.0,
                                          0.0,
                                          1.0,
                                          0.70710678118654752,
                                          0.57735026918962576,
                                          0.5,
                                          0.44721359549995794,
                                          0.40824829046386302,
                                          0.37796447300922722};

/// The unit vector of random bits: one component is 0, the others have one size and any signs; in
/// two dimensions the diagonals besides.
template <class Real, std::size_t N>
std::array<Real, N> simplex_direction(std::uint32_t bits) {
    const std::uint32_t choice = (bits >> 8 & 0xffffu) * (N == 2 ? 4u : std::uint32_t(N)) >> 16;
    const auto unit = Real(simplex_units[choice < N ? N : 3]);
    std::array<Real, N> g;
    for (std::size_t i = 0; i < N; ++i) g[i] = bits >> (31 - i) & 1 ? unit : -unit;
    if (choice < N) g[choice] = Real(0);
    return g;
}

/// A signal's value, and its derivative by g . d.
template <class Real>
struct SignalValue {
    Real value = 0, steepness = 0;
};

template <class Real>
SignalValue<Real> signal_value(const SimplexNoise& noise, std::uint32_t bits, Real along) {
    if (noise.signal == SimplexSignal::gradient) return {along, Real(1)};
    if (noise.signal == SimplexSignal::value)
        return {Real(std::int32_t(bits) >> 8) * Real(0x1p-23), Real(0)};
    const double turn = noise.turn(), phase = turn * double(along);
    return {Real(sine(phase)), Real(turn * cosine(phase))};
}

/// The noise at p divided by its amplitude, with the gradient, from corners in float64 and kernels
/// in Real.
template <class Real, std::size_t N>
NoiseSample<Real, N> simplex_signal(const SimplexNoise& noise, std::uint32_t seed,
                                    const Point<N>& p) {
    NoiseSample<Real, N> sum;
    const auto add = [&](const auto& corner, const std::array<Real, N>& d) {
        const std::uint32_t bits = simplex_bits(corner, seed);
        const auto g = simplex_direction<Real, N>(bits);
        Real t = Real(0.5), along = 0;
        for (std::size_t i = 0; i < N; ++i) {
            t -= d[i] * d[i];
            along += g[i] * d[i];
        }
        if (t < 0) return;
        const SignalValue<Real> s = signal_value(noise, bits, along);
        const Real t3 = t * t * t, t4 = t * t3;
        sum.value += t4 * s.value;
        for (std::size_t i = 0; i < N; ++i)
            sum.gradient[i] += t4 * s.steepness * g[i] - Real(8) * t3 * s.value * d[i];
    };
    for_simplex_corners<Real>(simplex_place(lattice_site<double>(p)), add);
    return sum;
}

/// simplex_signal in noise.dimensions dimensions at the first coordinates of p, by Real. Against
/// float64, float32 errs by at most 7e-8 in the value (1.5e-8 where the signal is the gradient) and
/// 5e-7 in a gradient's component, where waves are at most 1; more of them multiply
/// the first, and their square the second.
template <class Real>
NoiseSample<double, most_simplex_dimensions> sample_simplex(
    const SimplexNoise& noise, std::uint32_t seed, const Point<most_simplex_dimensions>& p);

}  // namespace burl
