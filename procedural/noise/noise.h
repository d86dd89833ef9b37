#pragma once
// Every kind of noise by its name, each in one text for float64, the reference, and for float32,
// whose errors the kinds' own headers state: value and gradient of one point in one call. The
// vectorised kernels (stream_kernels.h) round otherwise, with errors of their own.
#include "atlas/base/vec.h"
#include "procedural/noise/lattice_site.h"

namespace burl {

/// Value and gradient at a point in lattice coordinates. Real is float or double, N 1 to 4;
/// has_dimensions and has_period must hold, and what they exclude gives 0. With a time, points of
/// three coordinates look at the noise of four, and the slope along time is left out.
template <class Real, std::size_t N>
NoiseSample<Real, N> sample_noise(const NoiseSpec& noise, const Point<N>& p);

/// The same value without its gradient, in three dimensions: the same bits, in less time.
template <class Real, std::size_t N>
Real noise_value(const NoiseSpec& noise, const Point<N>& p);

/// Its value in float64, three dimensions.
double evaluate_noise(const NoiseSpec& noise, const Vec3d& p);

/// Perlin's improved noise with the published permutation, in float64.
double published_perlin_noise(const Vec3d& p);

}  // namespace burl
