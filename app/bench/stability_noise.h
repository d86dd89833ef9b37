#pragma once
// Noise written once more, straight from docs/reference/noise.md and in long double with its
// gradient: what textures are held against where float64 itself is in doubt.
#include <array>

#include "procedural/noise/spec.h"

namespace burl {

using LongPoint = std::array<long double, 3>;

struct LongNoise {
    long double value = 0.0L;
    LongPoint gradient{};
};

/// Whether true_noise has a text of its own for the noise: `value`, `perlin` and `simplex` without
/// period and time.
bool has_long_form(const NoiseSpec& noise);

/// Value and gradient at p, in lattice coordinates. Noises without a form of their own are those of
/// procedural/noise/noise.h in float64, at p rounded to it.
LongNoise long_noise(const NoiseSpec& noise, const LongPoint& p);

/// Whether the noise's value jumps somewhere, where a point's rounding decides which side it shows.
bool has_jumps(const NoiseSpec& noise);

}  // namespace burl
