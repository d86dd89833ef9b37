// f in fixed point: small cases by hand, and the error against float64 in units of the last bit.
#include "procedural/fixed/field.h"

#include <random>

#include <gtest/gtest.h>

namespace burl {
namespace {

double fixed(const Texture& texture, const FixedFormat& format, const Vec3d& s) {
    return FixedField(texture, format)(s);
}

Texture quadric(const Quadric& q) {
    Texture texture;
    texture.quadric = q;
    return texture;
}

TEST(FixedField, CutsCoordinatesDownwards) {
    const Texture ramp = quadric({.d = 0.5});  // f = s
    EXPECT_EQ(fixed(ramp, {4, 2}, {0.3, 0, 0}), 0.25);
    EXPECT_EQ(fixed(ramp, {4, 2}, {0.99, 0, 0}), 0.75);
    EXPECT_EQ(fixed(ramp, {4, 2}, {-0.3, 0, 0}), -0.5);
    EXPECT_EQ(fixed(ramp, {4, 16}, {-0x1p-17, 0, 0}), -0x1p-16);
}

TEST(FixedField, CutsProductsDownwards) {
    const Texture square = quadric({.a = 1.0});
    EXPECT_EQ(fixed(square, {4, 2}, {0.8, 0, 0}), 0.5);    // 0.75^2 = 0.5625
    EXPECT_EQ(fixed(square, {4, 2}, {0.3, 0, 0}), 0.0);    // 0.25^2 = 0.0625
    EXPECT_EQ(fixed(square, {4, 2}, {-0.3, 0, 0}), 0.25);  // 0.5^2
    // Both halves of 2 B s t, 0.75 * 0.5 = 0.375 each, are cut.
    EXPECT_EQ(fixed(quadric({.b = 1.0}), {4, 2}, {0.8, 0.6, 0}), 0.5);
    // (2.5 s) s: 2.5 * 0.75 = 1.875 is cut to 1.75, times 0.75 is 1.3125.
    EXPECT_EQ(fixed(quadric({.a = 2.5}), {4, 2}, {0.75, 0, 0}), 1.25);
    EXPECT_EQ(fixed(quadric({.j = 0.3}), {4, 2}, {}), 0.25);
}

TEST(FixedField, WrapsCoordinatesAndStopsSums) {
    const Texture ramp = quadric({.d = 0.5}), square = quadric({.a = 1.0});
    EXPECT_EQ(fixed(ramp, {2, 2}, {1.75, 0, 0}), 1.75);
    EXPECT_EQ(fixed(ramp, {2, 2}, {2.0, 0, 0}), -2.0);
    EXPECT_EQ(fixed(ramp, {2, 2}, {2.5, 0, 0}), -1.5);
    EXPECT_EQ(fixed(ramp, {2, 2}, {-2.25, 0, 0}), 1.75);
    EXPECT_EQ(fixed(square, {2, 2}, {1.5, 0, 0}), 1.75);  // 2.25
    EXPECT_EQ(fixed(quadric({.a = -1.0}), {2, 2}, {1.5, 0, 0}), -2.0);
    EXPECT_EQ(fixed(quadric({.a = 1e12}), {16, 16}, {1.0, 0, 0}), 0x1p15 - 0x1p-16);
    for (const double hopeless : {1e300, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_EQ(fixed(ramp, {8, 8}, {hopeless, 0, 0}), 0.0);
}

TEST(FixedField, AddsOctavesAtTheCutPoint) {
    Texture texture;
    NoiseTerm term;
    term.kind = NoiseKind::perlin, term.octaves = 2, term.frequency = {2, 4, 3};
    term.amplitude = 0.75, term.gain = 0.3, term.seed = 9, term.phase = {0.3, 0, -5};
    texture.noise = {term};
    const FixedFormat format{8, 6};
    const Vec3d s(1.32, -0.57, 2.9), cut(1.3125, -0.578125, 2.890625);  // multiples of 1/64
    // The lattice coordinates are cut again: 0.3 is no multiple of 1/64.
    const double first = fixed_noise({.kind = NoiseKind::perlin, .seed = 9}, format,
                                     Vec3d(2, 4, 3) * cut + Vec3d(0.3, 0, -5));
    const double second = fixed_noise({.kind = NoiseKind::perlin, .seed = 10}, format,
                                      2.0 * Vec3d(2, 4, 3) * cut + Vec3d(0.3, 0, -5));
    const auto units = [](double x) { return std::floor(64.0 * x) / 64.0; };
    EXPECT_EQ(fixed(texture, format, s), units(0.75 * first) + units(0.225 * second));
    texture.noise[0].shape = OctaveShape::absolute;
    EXPECT_EQ(fixed(texture, format, s),
              units(0.75 * std::abs(first)) + units(0.225 * std::abs(second)));
    texture.noise[0].shape = OctaveShape::ridged, texture.noise[0].octaves = 1;
    EXPECT_EQ(fixed(texture, format, s),
              units(0.75 * units((1.0 - std::abs(first)) * (1.0 - std::abs(first)))));
}

TEST(FixedField, SpreadsByDifferencesAlongBothSides) {
    const FixedField field(quadric({.a = 1.0, .d = 0.5}), {4, 2});  // f = s^2 + s
    const FixedSpread spread = spread_over(field, {0.3, 0, 0}, {Vec3d(0.5, 0, 0), Vec3d(0, 1, 0)});
    // At 0.25 the product (0.25 + 1) 0.25 is cut to 0.25; at 0.75 it is 1.3125, cut to 1.25.
    EXPECT_EQ(spread.value, 0.25);
    EXPECT_EQ(spread.u, 1.0);
    EXPECT_EQ(spread.v, 0.0);
    EXPECT_EQ(spread_over(field, {0.3, 0, 0}, {Vec3d(0.1, 0, 0), Vec3d(0.0)}).u, 0.0);
}

/// Wood and marble of the 1999 paper, eq. (5) and (7).
Texture wood() {
    Texture texture = quadric({.a = 1.0, .e = 1.0});
    NoiseTerm term;
    term.frequency = {4, 4, 1};
    texture.noise = {term};
    return texture;
}

Texture fixed_field_marble() {
    Texture texture = quadric({.i = 0.5});
    NoiseTerm term;
    term.amplitude = 0.5, term.frequency = Vec3d(2.0), term.octaves = 4;
    texture.noise = {term};
    return texture;
}

struct Errors {
    double worst = 0.0, rms = 0.0;
};

/// In units of 2^-F, over random points of a cube of side 4.
Errors errors_in_units(const Texture& texture, unsigned fraction_bits) {
    const FixedField field(texture, {8, fraction_bits});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    Errors errors;
    constexpr int count = 3000;
    for (int i = 0; i < count; ++i) {
        const Vec3d s{place(random), place(random), place(random)};
        const double error = std::ldexp(field(s) - evaluate_field(texture, s), int(fraction_bits));
        errors.worst = std::max(errors.worst, std::abs(error));
        errors.rms += error * error / count;
    }
    errors.rms = std::sqrt(errors.rms);
    return errors;
}

/// The bound is the header's. The smooth fade's slope is 3/2, of noise in [0,1]; frequencies go up
/// with the octaves as amplitudes go down.
TEST(FixedField, ErrsByAStatedNumberOfUnits) {
    // Quadric: 2 axes of slope 4, and |s| + 1 units each; noise: half of 20, slope 3/2 times
    // frequency (of cutting s) + 1 (of cutting the lattice coordinate) along three axes, and 1.
    const double wood_units = 2 * 4 + 2 * (2 + 1) + 0.5 * 20 + 1.5 * (5 + 5 + 2) + 1;
    double marble_units = 1 + 3;
    for (const double amplitude : {0.5, 0.25, 0.125, 0.0625})
        marble_units += 0.5 * 20 * amplitude + 1.5 * 3 * (1.0 + amplitude) + 1;
    for (const unsigned bits : {4u, 6u, 8u, 10u, 12u, 16u}) {
        const Errors of_wood = errors_in_units(wood(), bits),
                     of_marble = errors_in_units(fixed_field_marble(), bits);
        EXPECT_LE(of_wood.worst, wood_units) << bits;
        EXPECT_LE(of_marble.worst, marble_units) << bits;
        EXPECT_GE(of_wood.rms, 1.0) << bits;
        EXPECT_GE(of_marble.rms, 1.0) << bits;
    }
    // The error itself is halved by every bit.
    for (const Texture& texture : {wood(), fixed_field_marble()})
        for (const unsigned bits : {6u, 10u})
            EXPECT_NEAR(errors_in_units(texture, bits + 4).rms / errors_in_units(texture, bits).rms,
                        1.0, 0.15);
}

}  // namespace
}  // namespace burl
