#pragma once
// Every kind of noise by its name: value and gradient at one point in one call, in one template for
// float64, the reference, and for float32, whose errors the kinds' own headers state. The
// vectorised kernels (kernels/stream_kernels.h) round otherwise, with errors of their own.
#include "atlas/base/vec.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

/// Value and gradient at a point in lattice coordinates. Real is float or double, N 1 to 4; the
/// result is 0 where has_dimensions does not hold. has_period must hold. With a time, points of
/// three coordinates are evaluated in the noise of four dimensions, and the slope along time is
/// left out.
template <class Real, std::size_t N>
NoiseSample<Real, N> sample_noise(const NoiseSpec& noise, const Point<N>& p);

/// The value of sample_noise in three dimensions without its gradient: the same bits in less time.
template <class Real, std::size_t N>
Real noise_value(const NoiseSpec& noise, const Point<N>& p);

/// noise_value in float64.
double evaluate_noise(const NoiseSpec& noise, const Vec3d& p);

/// Perlin's improved noise with the published permutation, in float64.
double published_perlin_noise(const Vec3d& p);

/// The mean of n over uniform points in three dimensions, in four if `timed` (Worley's: of F1), to
/// within 1e-3. Means stand for octaves too fine for a sample: leaving |n| out altogether would
/// darken the distance.
constexpr double mean_value(NoiseKind kind, bool timed = false) {
    if (kind != NoiseKind::worley) return 0.0;
    return timed ? 0.5901 : 0.5205;
}

/// The mean of |n| over uniform points, to within 1e-3 (measured over 2e6 points); value noise is
/// taken with the smooth fade.
constexpr double mean_absolute(NoiseKind kind, bool timed = false) {
    switch (kind) {
        case NoiseKind::value:
            return timed ? 0.2572 : 0.3032;
        case NoiseKind::perlin:
            return timed ? 0.2376 : 0.2203;
        case NoiseKind::perlin2002:
            return timed ? 0.2358 : 0.2203;
        case NoiseKind::perlin1985:
            return 0.1503;
        case NoiseKind::simplex:
            return timed ? 0.1746 : 0.0936;
        case NoiseKind::worley:
            return mean_value(kind, timed);
        case NoiseKind::cell:
        case NoiseKind::white:
            return 0.5;
    }
    return 0.0;
}

}  // namespace burl
