// Noise beside its rivals: each approximates it as its order says.
#include "app/bench/rivals.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(BenchRivals, ErrByTheirOrder) {
    const std::vector<BenchResult> results = bench_rivals(1, 256);
    ASSERT_EQ(results.size(), 24u);
    const auto rms = [&](std::size_t group, std::size_t way) {
        return results[8 * group + way].error->rms;
    };
    for (std::size_t group = 0; group < 3; ++group) {
        EXPECT_LT(results[8 * group].error->max, 3e-7);
        EXPECT_LT(results[8 * group + 1].error->max, 3e-7);
        // Trilinear lookups are of second order: a quarter of the error at half the distance, and
        // the same whatever the texels' distance.
        EXPECT_NEAR(rms(group, 3) / rms(group, 4), 4.0, 0.8);
        EXPECT_NEAR(rms(group, 3) / rms(1, 3), 1.0, 0.4);
        EXPECT_GT(rms(group, 2), 3.0 * rms(group, 3));
    }
    // Parabolas are of third order where the noise is smooth, and useless beyond a cell.
    EXPECT_GT(rms(1, 6) / rms(1, 5), 4.0);
    EXPECT_GT(rms(2, 7), 0.1);
    EXPECT_LT(rms(0, 5), 1e-4);
}

}  // namespace
}  // namespace burl
