#include "app/bench/forward.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(BenchForwardCubes, CountWhatThePapersCubesTake) {
    const std::vector<CubeBench> rows = bench_forward_cubes(1, 128);
    ASSERT_EQ(rows.size(), 13u);
    // Marble: along a face of 2 units lie 2 + 4 + 8 + 16 cells of its octaves, 16 of them abreast.
    // Wood: 5 cells along s and t, 1 along r, and each face's scan lines have an axis of their own.
    constexpr std::int64_t lines = 3 * 128, wood = 128 * (5 + 5 + 1), marble = lines * 30;
    for (const CubeBench& row : rows) {
        const bool forward = row.method.starts_with("forward");
        const bool octaves = row.method == "forward, octave by octave";
        EXPECT_GT(row.milliseconds, 0.0);
        EXPECT_LE(row.error, row.method == "forward, float32" ? 1e-4 : 1e-6) << row.method;
        if (row.method == "texel by texel, float64" || row.method == "forward, float64") {
            EXPECT_EQ(row.other_codes, 0) << row.method;
        }
        EXPECT_EQ(row.largest_step > 0, row.other_codes > 0);
        EXPECT_EQ(row.cells, !forward ? 0 : row.texture == "bresenham-wood" ? wood : marble);
        if (row.method == "forward, float64") {
            EXPECT_EQ(row.runs, row.texture == "bresenham-wood" ? wood : lines * 16);
        }
        if (octaves) {
            EXPECT_EQ(row.runs, lines * (30 + 1));
        }
    }
}

TEST(BenchForwardGrowth, ShowsErrorsGrowThroughACell) {
    for (const GrowthBench& row : bench_forward_growth()) {
        ASSERT_GE(row.errors.size(), 6u);
        EXPECT_EQ(row.errors.back().texel, row.frequency == 1.0 ? 127u : 15u);
        EXPECT_LT(row.errors.front().largest, 1e-7);
        if (row.precision != "float32") continue;
        EXPECT_GT(row.errors.back().largest, 2.0 * row.errors.front().largest) << row.noise;
        EXPECT_LT(row.errors.back().largest, 5e-3) << row.noise;
    }
}

}  // namespace
}  // namespace burl
