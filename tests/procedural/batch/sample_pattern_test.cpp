// Places and weights of samples against their definition.
#include "procedural/batch/sample_pattern.h"

#include <cmath>

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(SamplePatternTest, WeightsAreThoseOfPbrtTimesOneFactor) {
    for (int i = -32; i <= 32; ++i)
        for (int j = -32; j <= 32; ++j) {
            const double u = i / 64.0, v = j / 64.0;
            const double expected = std::exp(0.5 - 2.0 * (u * u + v * v));
            EXPECT_NEAR(gaussian_weight(u, v), expected, 2e-15 * expected) << u << " " << v;
        }
}

TEST(SamplePatternTest, EveryCellHasOneSampleAndTexelsDiffer) {
    const SamplePattern pattern(12);
    EXPECT_EQ(pattern.columns(), 3);
    EXPECT_EQ(pattern.rows(), 4);
    for (int i = 0; i < pattern.samples(); ++i) {
        const auto [u, v] = pattern(i, 5, 9);
        EXPECT_EQ(int((double(u) + 0.5) * 3.0), i % 3);
        EXPECT_EQ(int((double(v) + 0.5) * 4.0), i / 3);
        EXPECT_NE(pattern(i, 6, 9), pattern(i, 5, 9));
    }
}

}  // namespace
}  // namespace burl
