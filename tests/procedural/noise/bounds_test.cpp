#include "procedural/noise/bounds.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

TEST(NoiseBounds, HoldEveryNoise) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-50.0, 50.0);
    for (const auto& [name, noise] : test::noise_cases(3))
        for (const OctaveShape shape :
             {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged}) {
            const NoiseBounds bounds = shaped(shape, noise_bounds(noise));
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
