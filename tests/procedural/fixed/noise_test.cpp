#include "procedural/fixed/noise.h"

#include <gtest/gtest.h>

#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

struct FixedErrors {
    double worst = 0.0, rms = 0.0;  ///< in units of 2^-F
};

/// Against float64, within the format's range but for its last cell.
FixedErrors fixed_errors(const NoiseSpec& noise, const FixedFormat& format) {
    const double reach = std::ldexp(1.0, int(format.integer_bits) - 1) - 1.0;
    std::mt19937 random(1);
    FixedErrors errors;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        const Point<3> p = test::random_point<3>(random, reach);
        const double error = std::ldexp(
            fixed_noise(noise, format, {p[0], p[1], p[2]}) - noise_value<double>(noise, p),
            int(format.fraction_bits));
        errors.worst = std::max(errors.worst, std::abs(error));
        errors.rms += error * error / count;
    }
    errors.rms = std::sqrt(errors.rms);
    return errors;
}

double stated_units(const NoiseSpec& noise) {
    if (noise.kind == NoiseKind::perlin || noise.fade == Fade::quintic) return 40.0;
    return noise.fade == Fade::smooth ? 20.0 : 10.0;
}

TEST(FixedNoise, ErrsByAFewUnitsOfItsLastBit) {
    for (const unsigned bits : {2u, 4u, 8u, 12u, 16u})
        for (const NoiseSpec& noise : {NoiseSpec{.kind = NoiseKind::value, .fade = Fade::linear},
                                       NoiseSpec{.kind = NoiseKind::value, .fade = Fade::smooth},
                                       NoiseSpec{.kind = NoiseKind::value, .fade = Fade::quintic},
                                       NoiseSpec{.kind = NoiseKind::perlin, .seed = 5}}) {
            const FixedErrors errors = fixed_errors(noise, {8, bits});
            EXPECT_LE(errors.worst, stated_units(noise)) << bits;
            EXPECT_LE(errors.rms, 0.22 * stated_units(noise)) << bits;
            EXPECT_GE(errors.rms, 1.0) << bits;  // else the format was not applied
        }
}

TEST(FixedNoise, IsExactWhereNothingIsLost) {
    // At lattice points value noise is the lattice value cut to F bits, and Perlin's is 0.
    for (int i = 0; i < 50; ++i) {
        const Point<3> p{double(i), double(3 * i % 7), double(i / 3)};
        const double n = sample_noise<double>({.kind = NoiseKind::value}, p).value;
        EXPECT_EQ(fixed_noise({.kind = NoiseKind::value}, {8, 8}, {p[0], p[1], p[2]}),
                  std::floor(n * 256.0) / 256.0);
        EXPECT_EQ(fixed_noise({.kind = NoiseKind::perlin}, {8, 8}, {p[0], p[1], p[2]}), 0.0);
    }
    // Halfway along a cell's edge linear interpolation is the mean.
    const double a =
        fixed_noise({.kind = NoiseKind::value, .fade = Fade::linear}, {8, 8}, {3, 1, 2});
    const double b =
        fixed_noise({.kind = NoiseKind::value, .fade = Fade::linear}, {8, 8}, {4, 1, 2});
    EXPECT_NEAR(fixed_noise({.kind = NoiseKind::value, .fade = Fade::linear}, {8, 8}, {3.5, 1, 2}),
                0.5 * (a + b), 1.0 / 256.0);
}

TEST(FixedNoise, RepeatsAfterTheIntegerBitsAndSeesOnlyTheFractionBits) {
    std::mt19937 random(2);
    const NoiseSpec noise{.kind = NoiseKind::perlin};
    for (int i = 0; i < 100; ++i) {
        const Point<3> p = test::random_point<3>(random, 100.0);
        const Vec3d v(std::floor(p[0] * 16) / 16, std::floor(p[1] * 16) / 16,
                      std::floor(p[2] * 16) / 16);
        EXPECT_EQ(fixed_noise(noise, {5, 4}, v),
                  fixed_noise(noise, {5, 4}, v + Vec3d(32, -64, 96)));
        // The last cell's upper corners are the first one's lower ones.
        EXPECT_NEAR(fixed_noise(noise, {5, 16}, Vec3d(0x1p4 - 0x1p-16, v.y, v.z)),
                    fixed_noise(noise, {5, 16}, Vec3d(-0x1p4, v.y, v.z)), 0x1p-10);
        EXPECT_EQ(fixed_noise(noise, {5, 4}, v), fixed_noise(noise, {5, 4}, v + Vec3d(0.06)));
    }
    EXPECT_EQ(fixed_noise(noise, {8, 8}, Vec3d(1e300, 0.5, 0.25)),
              fixed_noise(noise, {8, 8}, Vec3d(0.0, 0.5, 0.25)));
}

}  // namespace
}  // namespace burl
