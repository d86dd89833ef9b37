// What `burl bench scale` reports: every stage at every size, slopes and bytes of known series, and
// peaks that hold what the stage makes. No times are asserted.
#include "app/bench/scale.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "atlas/base/json.h"
#include "tests/app/programs/run_program.h"

namespace burl {
namespace {

TEST(ScaleBench, SlopesAreTheExponents) {
    const std::array x{1.0, 2.0, 4.0, 8.0};
    EXPECT_NEAR(log_log_slope(x, std::array{3.0, 6.0, 12.0, 24.0}), 1.0, 1e-12);
    EXPECT_NEAR(log_log_slope(x, std::array{5.0, 20.0, 80.0, 320.0}), 2.0, 1e-12);
    EXPECT_NEAR(log_log_slope(x, std::array{7.0, 7.0, 7.0, 7.0}), 0.0, 1e-12);
    // Residuals (+d, -d, -d, +d) are orthogonal to 1 and to log(x).
    EXPECT_NEAR(log_log_slope(x, std::array{2.0 * 1.1, 4.0 / 1.1, 8.0 / 1.1, 16.0 * 1.1}), 1.0,
                1e-12);
}

TEST(ScaleBench, BytesOfAUnitLeaveOutWhatEveryBakeTakes) {
    const ScaleSeries series{"s", "texel", {{100, 2.0, 5e6 + 100 * 7}, {400, 16.0, 5e6 + 400 * 7}}};
    EXPECT_DOUBLE_EQ(series.bytes_per_unit(), 7.0);
    EXPECT_NEAR(series.exponent(), 1.5, 1e-12);  // eight times the time for four times the units
}

TEST(ScaleBench, EveryStageHasEverySize) {
    const ScaleSizes sizes{{1'200, 4'800}, 128, {512, 1024}, 300};
    const std::vector<ScaleSeries> all = bench_scale(sizes);
    std::vector<std::string> names;
    for (const ScaleSeries& series : all) {
        SCOPED_TRACE(series.stage);
        names.push_back(series.stage);
        ASSERT_EQ(series.points.size(), 2u);
        const bool texels = series.unit == "texel";
        EXPECT_EQ(series.points[0].units, texels ? 512.0 * 512 : 1200.0);
        EXPECT_EQ(series.points[1].units, texels ? 1024.0 * 1024 : 4800.0);
        for (const ScalePoint& point : series.points) EXPECT_GE(point.seconds, 0.0);
        EXPECT_GT(series.points[1].seconds, 0.0);
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{
                  "connectivity", "quad layout", "quad points", "patch layout", "patch points",
                  "chart layout", "chart points", "points", "synthesis", "write", "material"}));
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
    for (const ScaleSeries& series : all)
        if (series.stage == "synthesis" || series.stage == "material") {
            EXPECT_GT(series.points[1].peak_bytes, 3.0 * 1024 * 1024) << series.stage;
        }
#endif
}

}  // namespace
}  // namespace burl
