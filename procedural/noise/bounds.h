#pragma once
// Ranges of the kinds of noise (docs/reference/noise.md, "Ranges and errors").
#include <algorithm>
#include <cmath>

#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"

namespace burl {

/// The range of a noise: low <= n <= high, up to the noise's error in float32.
struct NoiseBounds {
    double low = -1.0, high = 1.0;
};

/// The range of a noise in three dimensions, or in four where it has a time.
inline NoiseBounds noise_bounds(const NoiseSpec& noise) {
    const bool timed = noise.time.has_value();
    const auto around_zero = [](double size) { return NoiseBounds{-size, size}; };
    switch (noise.kind) {
        case NoiseKind::value:
        case NoiseKind::cell:
        case NoiseKind::white:
            return around_zero(1.0);
        case NoiseKind::perlin:
        case NoiseKind::perlin2002:
            return around_zero(timed ? 1.5366 : 1.0364);
        case NoiseKind::perlin1985:
            return around_zero(0.8661);
        case NoiseKind::simplex:
            return around_zero(timed ? 1.0 : 0.348);
        case NoiseKind::worley:
            return {0.0, timed ? 2.0 : 1.7321};
    }
    return {};
}

/// The range of shape(n) for noise in the range `n`.
inline NoiseBounds shaped(OctaveShape shape, const NoiseBounds& n) {
    if (shape == OctaveShape::plain) return n;
    const double size = std::max(std::abs(n.low), std::abs(n.high));
    if (shape == OctaveShape::absolute) return {0.0, size};
    return {0.0, std::max(1.0, (1.0 - size) * (1.0 - size))};
}

}  // namespace burl
