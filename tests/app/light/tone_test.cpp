// The tone curve against the figures that its specification states.
#include "app/light/tone.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(Tone, TakesOnlyTheReflectionFromColoursWithinItsRange) {
    for (double r = 0.08; r <= 0.8; r += 0.06)
        for (double g = 0.08; g <= 0.8; g += 0.09)
            for (const double b : {0.08, 0.3, 0.8}) {
                const Vec3d c = tone_mapped({r, g, b});
                EXPECT_NEAR(c.x, r - 0.04, 1e-15);
                EXPECT_NEAR(c.y, g - 0.04, 1e-15);
                EXPECT_NEAR(c.z, b - 0.04, 1e-15);
            }
}

TEST(Tone, DarkLightKeepsWhatTheSpecificationLeavesIt) {
    EXPECT_EQ(tone_mapped(Vec3d(0.0)), Vec3d(0.0));
    // x - (x - x^2 / (4 F90)) = x^2 / 0.16.
    for (const double x : {0.01, 0.04, 0.07})
        EXPECT_NEAR(tone_mapped(Vec3d(x)).x, x * x / 0.16, 1e-15);
    EXPECT_NEAR(tone_mapped(Vec3d(0.08)).x, 0.04, 1e-15);
}

TEST(Tone, BrightLightFollowsTheFormulaWorkedByHand) {
    // Grey 1: 1 - 0.24^2 / (0.96 + 1 - 2 * 0.76) = 1 - 0.0576 / 0.44.
    EXPECT_NEAR(tone_mapped(Vec3d(1.0)).y, 0.869090909090909, 1e-12);
    // Red 10: p' = 1 - 0.0576 / 9.48; g = 1 / (0.15 (10 - p') + 1); the others get p' (1 - g).
    const Vec3d red = tone_mapped({10.0, 0.0, 0.0});
    EXPECT_NEAR(red.x, 0.993924050632911, 1e-12);
    EXPECT_NEAR(red.y, 0.571141, 2e-6);
    EXPECT_EQ(red.y, red.z);
}

TEST(Tone, GrowsWithoutEverReachingOne) {
    double before = -1.0;
    for (double x = 0.0; x < 40.0; x += 0.003) {
        const double now = tone_mapped(Vec3d(x)).x;
        EXPECT_GT(now, before);
        EXPECT_LT(now, 1.0);
        before = now;
    }
}

TEST(Tone, KeepsTheHueAndIsContinuousAtTheShoulder) {
    for (const double peak : {0.79, 0.81, 1.5, 6.0}) {
        const Vec3d c = tone_mapped(Vec3d(peak, 0.5 * peak, 0.25 * peak));
        // Differences from the darkest keep their ratio: a plane with the white axis.
        EXPECT_NEAR((c.y - c.z) / (c.x - c.z), (0.5 - 0.25) / (1.0 - 0.25), 1e-12);
    }
    EXPECT_NEAR(tone_mapped({0.8 + 1e-9, 0.2, 0.1}).x, tone_mapped({0.8 - 1e-9, 0.2, 0.1}).x, 1e-8);
}

TEST(Tone, ExposureCountsInStops) {
    LightOptions options{"studio"};
    options.exposure = 1.0, options.tone_curve = false;
    EXPECT_EQ(developed(Vec3d(0.3), options), Vec3d(0.6));
    options.exposure = -2.0, options.tone_curve = true;
    EXPECT_EQ(developed(Vec3d(4.0), options), tone_mapped(Vec3d(1.0)));
    options.light = "headlight", options.exposure = 0.0;
    EXPECT_EQ(developed(Vec3d(0.9), options), Vec3d(0.9));
}

}  // namespace
}  // namespace burl
