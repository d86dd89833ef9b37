// Rotations about the axes: quarter turns are exact, all others those of the C library up to
// rounding of the angle in radians.
#include "procedural/numbers/rotation.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(Rotation, QuarterTurnsAreExact) {
    EXPECT_EQ(cosine_and_sine(0.0), Vec2d(1.0, 0.0));
    for (const double turns : {-8.0, -4.0, 0.0, 4.0, 400.0}) {
        EXPECT_EQ(cosine_and_sine(90.0 * turns), Vec2d(1.0, 0.0)) << turns;
        EXPECT_EQ(cosine_and_sine(90.0 * (turns + 1.0)), Vec2d(0.0, 1.0)) << turns;
        EXPECT_EQ(cosine_and_sine(90.0 * (turns + 2.0)), Vec2d(-1.0, 0.0)) << turns;
        EXPECT_EQ(cosine_and_sine(90.0 * (turns + 3.0)), Vec2d(0.0, -1.0)) << turns;
    }
    EXPECT_EQ(rotation_about(2, 0.0), Mat3d(1.0));
    EXPECT_EQ(rotation_about(0, 90.0) * Vec3d(0, 1, 0), Vec3d(0, 0, 1));
    EXPECT_EQ(rotation_about(1, 90.0) * Vec3d(0, 0, 1), Vec3d(1, 0, 0));
    EXPECT_EQ(rotation_about(2, 90.0) * Vec3d(1, 0, 0), Vec3d(0, 1, 0));
}

TEST(Rotation, OtherAnglesAreThoseOfTheCLibrary) {
    for (double degrees = -720.0; degrees <= 720.0; degrees += 0.37) {
        const double angle = degrees * std::numbers::pi / 180.0;
        EXPECT_NEAR(cosine_and_sine(degrees).x, std::cos(angle), 4e-15) << degrees;
        EXPECT_NEAR(cosine_and_sine(degrees).y, std::sin(angle), 4e-15) << degrees;
    }
}

}  // namespace
}  // namespace burl
