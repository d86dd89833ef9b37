// `burl bench gl`: its rows, that times add up, and errors that belong to each precision.
#include "app/bench/gl/synthesis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

using testing::HasSubstr;

using GlBenchTest = GlTest;

TEST_F(GlBenchTest, RowsTellTimesAndErrorsOfOneTextureAndTheyAddUp) {
    const GlBenchReport report = bench_gl("osmesa", 1, {{32}, {2}});
    EXPECT_THAT(report.opengl, HasSubstr("OSMesa"));
    std::vector<std::string> names;
    for (const GlBench& row : report.rows) {
        names.push_back(row.result.time.name);
        EXPECT_EQ(row.result.time.rounds, 1);
        EXPECT_EQ(row.result.time.units, 32.0 * 32.0);
        EXPECT_GT(row.result.time.median, 0.0);
    }
    EXPECT_THAT(names, testing::IsSupersetOf({"host, 1 thread", "host, all threads", "single pass",
                                              "multipass 32f", "multipass 16f", "multipass 8",
                                              "levels, host", "levels, OpenGL"}));
    EXPECT_EQ(report.rows[0].passes, 0);
    EXPECT_THAT(report.rows[0].result.time.group, HasSubstr("2 octaves, 32 x 32"));
    // Colours of the same texture, not of another one or of none: each precision's errors.
    for (const GlBench& row : report.rows) {
        const std::string& name = row.result.time.name;
        if (row.octaves == 0) continue;
        ASSERT_TRUE(row.result.error);
        const double bound = name == "multipass 16f" ? 0.05 : name == "multipass 8" ? 0.9 : 1e-5;
        EXPECT_LT(row.result.error->max, bound) << name;
        EXPECT_GT(row.result.error->rms, bound * 1e-5) << name;
    }
    int drawn = 0;
    for (const GlBench& row : report.rows) {
        if (row.passes == 0 || row.octaves == 0) continue;
        ++drawn;
        const GlColdStart& cold = row.cold;
        EXPECT_GT(cold.context, 0.0);
        EXPECT_GT(cold.compile, 0.0);
        EXPECT_GE(cold.total, cold.context + cold.compile + cold.maps + cold.draw);
        EXPECT_GT(row.parts.draw, 0.0);
        EXPECT_GE(row.result.time.median, row.parts.draw + row.parts.transfer);  // one round
    }
    EXPECT_GE(drawn, 2);
}

TEST_F(GlBenchTest, LevelsAreTheHosts) {
    const GlBenchReport report = bench_gl("osmesa", 1, {{32}, {}});
    ASSERT_EQ(report.rows.size(), 2u);
    EXPECT_FALSE(report.rows[0].result.error);
    ASSERT_TRUE(report.rows[1].result.error);
    EXPECT_LT(report.rows[1].result.error->max, 1e-6);
    EXPECT_EQ(report.rows[1].passes, 5);
}

}  // namespace
}  // namespace burl
