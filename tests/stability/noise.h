#pragma once
// A second implementation of noise and its gradient, directly from docs/reference/noise.md and in
// long double: the reference where float64 itself is in doubt.
#include <array>

#include "procedural/noise/spec.h"

namespace burl {

using LongPoint = std::array<long double, 3>;

/// A noise's value and gradient.
struct LongNoise {
    long double value = 0.0L;
    LongPoint gradient{};
};

/// Whether long_noise() implements the noise itself: `value`, `perlin` and `simplex` without period
/// and time.
bool has_long_form(const NoiseSpec& noise);

/// Returns value and gradient at p, in lattice coordinates. Other noises are evaluated by
/// procedural/noise/noise.h in float64, at p rounded to float64.
LongNoise long_noise(const NoiseSpec& noise, const LongPoint& p);

/// Whether the noise is discontinuous: there, the rounding of a point decides its side.
bool has_jumps(const NoiseSpec& noise);

}  // namespace burl
