#include "procedural/model/texture.h"

#include <gtest/gtest.h>

#include "procedural/model/octaves.h"

#include "procedural/noise/noise.h"

namespace burl {
namespace {

double unit_value(std::uint32_t seed, const Vec3d& p) {
    return 0.5 * (1.0 + evaluate_noise(
                            {.kind = NoiseKind::value, .fade = Fade::smooth, .seed = seed}, p));
}

TEST(Field, QuadricIsTheExpandedPolynomial) {
    Texture texture;
    texture.quadric = {2, -3, 5, 7, -11, 13, 17, 19, -23, 29};
    const double s = 0.5, t = -0.25, r = 2.0;
    // Eq. (3) term by term.
    const double expected = 2 * s * s + 2 * -3 * s * t + 2 * 5 * s * r + 2 * 7 * s + -11 * t * t +
                            2 * 13 * t * r + 2 * 17 * t + 19 * r * r + 2 * -23 * r + 29;
    EXPECT_DOUBLE_EQ(evaluate_field(texture, {s, t, r}), expected);
}

TEST(Field, MarbleIsEquationSeven) {
    Texture texture;
    texture.quadric.i = 0.5;
    NoiseTerm term;
    term.amplitude = 0.5, term.frequency = Vec3d(2.0), term.octaves = 4;
    texture.noise = {term};
    const Vec3d s(0.3, -1.7, 2.2);
    double expected = s.z;
    for (std::uint32_t i = 1; i <= 4; ++i)
        expected += std::pow(2.0, -double(i)) * unit_value(i - 1, std::pow(2.0, i) * s);
    EXPECT_NEAR(evaluate_field(texture, s), expected, 1e-14);
}

TEST(Field, PhaseIsNeverScaled) {
    // Fire, eq. (8): f = r + sum 2^-i n(2^i s, 0, 2^i r + phi).
    Texture texture;
    texture.quadric.i = 0.5;
    NoiseTerm term;
    term.amplitude = 0.5, term.frequency = {2, 0, 2}, term.phase = {0, 0, 0.37}, term.octaves = 3;
    texture.noise = {term};
    const Vec3d s(0.3, 5.0, 0.8);
    const double expected = s.z + 0.5 * unit_value(0, {0.6, 0, 1.6 + 0.37}) +
                            0.25 * unit_value(1, {1.2, 0, 3.2 + 0.37}) +
                            0.125 * unit_value(2, {2.4, 0, 6.4 + 0.37});
    EXPECT_NEAR(evaluate_field(texture, s), expected, 1e-14);
}

TEST(Field, MatrixReplacesFrequencyAndPhase) {
    Texture texture;
    NoiseTerm term;
    term.frequency = Vec3d(99.0), term.phase = Vec3d(99.0);
    term.matrix = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    term.octaves = 2, term.lacunarity = 3.0, term.gain = 0.25, term.seed = 40;
    texture.noise = {term};
    const Vec3d s(0.1, 0.2, -0.3);
    const Vec3d f(0.1 + 0.4 - 0.9, 0.5 + 1.2 - 2.1, 0.9 + 2.0 - 3.3), phase(4, 8, 12);
    EXPECT_NEAR(evaluate_field(texture, s),
                unit_value(40, f + phase) + 0.25 * unit_value(41, 3.0 * f + phase), 1e-13);
}

TEST(Field, RangesHaveTheirDefaults) {
    const Vec3d s(0.4, 1.3, 2.6);
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin}) {
        Texture texture;
        texture.noise.emplace_back().kind = kind;
        const double natural = evaluate_field(texture, s);
        texture.noise[0].range = NoiseRange::unit;
        const double unit = evaluate_field(texture, s);
        texture.noise[0].range = NoiseRange::bipolar;
        const double bipolar = evaluate_field(texture, s);
        EXPECT_NEAR(bipolar, 2.0 * unit - 1.0, 1e-15);
        EXPECT_EQ(natural, kind == NoiseKind::value ? unit : bipolar);
    }
}

TEST(Field, GainZeroAndAmplitudeZeroAddNothing) {
    Texture texture;
    NoiseTerm term;
    term.octaves = 5, term.gain = 0.0;
    texture.noise = {term};
    const Vec3d s(0.4, 1.3, 2.6);
    EXPECT_EQ(evaluate_field(texture, s), unit_value(0, s));
    texture.noise[0].amplitude = 0.0;
    EXPECT_EQ(evaluate_field(texture, s), 0.0);
}

TEST(Quadric, ChangesOfItsGradientDoNotDrownInItsLinearPart) {
    const Quadric q{1, 2, -3, 1e9, 0.5, 6, -1e9, 0.25, 1e9, 10};
    const Vec3d step(0x1p-40, -0x1p-38, 0x1p-39);
    EXPECT_EQ(half_gradient_change(q, step), Vec3d(1 - 8 - 6, 2 - 2 + 12, -3 - 24 + 0.5) * 0x1p-40);
}

}  // namespace
}  // namespace burl
