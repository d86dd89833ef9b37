// The suite's counts, which no machine changes.
#include "app/bench/gl/economy.h"

#include <gtest/gtest.h>

#include "app/bench/gl/view.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

TEST(BenchEconomy, EditsDoWhatTheyChange) {
    const std::vector<EditBench> rows = bench_edits(3, 64);
    ASSERT_EQ(rows.size(), 5u);
    const SynthesisWork &whole = rows[0].work, &colour = rows[1].work, &amplitude = rows[2].work,
                        &phase = rows[3].work, &camera = rows[4].work;
    EXPECT_GT(whole.texels, 1000u);
    EXPECT_GT(whole.octaves, whole.texels);
    EXPECT_EQ(colour.texels, whole.texels);
    EXPECT_EQ(colour.octaves, 0u);
    EXPECT_EQ(amplitude.octaves, 0u);
    EXPECT_EQ(phase.octaves, whole.texels) << "one term of four";
    EXPECT_EQ(camera, SynthesisWork{});
}

TEST(BenchEconomy, CoarseLevelsSpareOctaves) {
    double before = -1.0;
    for (const std::uint32_t level : {0u, 1u, 3u}) {
        const SparedOctaves row = spared_by_band_limit("marble", 128, level);
        EXPECT_GT(row.work.texels, 0u);
        EXPECT_GT(row.share(Skip::band_limit), before);
        before = row.share(Skip::band_limit);
    }
    EXPECT_LE(before, 1.0);
}

using BenchViewTest = GlTest;

TEST_F(BenchViewTest, MadeCoversWhatIsVisible) {
    ViewBenchSubjects subjects;
    subjects.size = 128, subjects.picture = {80, 60}, subjects.views = 1, subjects.samples = {};
    const std::vector<ViewBench> rows = bench_views("osmesa", subjects);
    EXPECT_EQ(rows.size(), 2u * 3 * 3);
    for (const ViewBench& row : rows) {
        EXPECT_GT(row.visible, 0u);
        EXPECT_GE(row.made, row.visible) << row.scene << " " << row.atlas << " " << row.cell;
        EXPECT_GE(row.worst, row.made_over_visible() - 1e-9);
    }
    EXPECT_LT(rows[0].made, rows[2].made) << "single texels and whole tiles";
}

}  // namespace
}  // namespace burl
