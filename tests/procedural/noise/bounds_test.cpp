// The ranges that docs/reference/noise.md states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "procedural/noise/fractal_sum.h"
#include "procedural/noise/spec.h"
#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

/// low <= n <= high, up to the noise's error in float32.
struct Bounds {
    double low = -1.0, high = 1.0;
};

/// The bounds of noise in three dimensions.
Bounds bounds_of(const NoiseSpec& noise) {
    const auto around_zero = [](double size) { return Bounds{-size, size}; };
    switch (noise.kind) {
        case NoiseKind::value:
        case NoiseKind::cell:
        case NoiseKind::white:
            return around_zero(1.0);
        case NoiseKind::perlin:
        case NoiseKind::perlin2002:
            return around_zero(1.0364);
        case NoiseKind::perlin1985:
            return around_zero(0.8661);
        case NoiseKind::simplex:
            return around_zero(0.348);
        case NoiseKind::worley:
            return {0.0, 1.7321};
    }
    return {};
}

/// The bounds of what a shape makes of noise within `n`.
Bounds shaped_bounds(OctaveShape shape, const Bounds& n) {
    if (shape == OctaveShape::plain) return n;
    const double size = std::max(std::abs(n.low), std::abs(n.high));
    if (shape == OctaveShape::absolute) return {0.0, size};
    return {0.0, std::max(1.0, (1.0 - size) * (1.0 - size))};
}

TEST(NoiseBounds, HoldEveryNoise) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-50.0, 50.0);
    for (const auto& [name, noise] : test::noise_cases(3))
        for (const OctaveShape shape :
             {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged}) {
            const Bounds bounds = shaped_bounds(shape, bounds_of(noise));
            double low = infinity, high = -infinity;
            for (int i = 0; i < 4000; ++i) {
                const double n = shaped(
                    shape,
                    evaluate_noise(noise, Vec3d{place(random), place(random), place(random)}));
                low = std::min(low, n), high = std::max(high, n);
            }
            EXPECT_GE(low, bounds.low) << name;
            EXPECT_LE(high, bounds.high) << name;
            EXPECT_GT(high - low, 0.2 * (bounds.high - bounds.low)) << name;
        }
}

}  // namespace
}  // namespace burl
