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

}  // namespace burl
