#include "procedural/noise/fractal_sum.h"

#include <gtest/gtest.h>

#include "procedural/model/octaves.h"
#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

double octave_value(std::uint32_t k, const Point<3>& p) {
    return sample_noise<double>({.kind = NoiseKind::perlin, .seed = k}, p).value;
}

NoiseSample<double, 3> sum_of(const FractalSum& fractal, const Point<3>& p) {
    return fractal_sum<double>(fractal, p, [](std::uint32_t k, const Point<3>& q) {
        return sample_noise<double>({.kind = NoiseKind::perlin, .seed = k}, q);
    });
}

TEST(FractalSum, IsTheSumOfItsOctaves) {
    const Point<3> p{0.3, -1.4, 2.7}, q{0.9, -4.2, 8.1};
    const double a = octave_value(0, p), b = octave_value(1, q);
    const auto ridge = [](double n) { return (1.0 - std::abs(n)) * (1.0 - std::abs(n)); };
    EXPECT_NEAR(sum_of({OctaveShape::plain, 2, 3.0, 0.25}, p).value, a + 0.25 * b, 1e-13);
    EXPECT_NEAR(sum_of({OctaveShape::absolute, 2, 3.0, 0.25}, p).value,
                std::abs(a) + 0.25 * std::abs(b), 1e-13);
    EXPECT_NEAR(sum_of({OctaveShape::ridged, 2, 3.0, 0.25}, p).value, ridge(a) + 0.25 * ridge(b),
                1e-13);
}

TEST(FractalSum, NormalisedSumsKeepTheRangeOfOneOctave) {
    std::mt19937 random(1);
    for (const OctaveShape shape :
         {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged}) {
        for (int i = 0; i < 500; ++i) {
            const Point<3> p = test::random_point<3>(random, 20.0);
            const double raw = sum_of({shape, 5, 2.0, 0.5, false}, p).value;
            const double normalised = sum_of({shape, 5, 2.0, 0.5, true}, p).value;
            EXPECT_NEAR(normalised * (1 + 0.5 + 0.25 + 0.125 + 0.0625), raw, 1e-14);
            EXPECT_LE(normalised, 1.0364);
            EXPECT_GE(normalised, shape == OctaveShape::plain ? -1.0364 : 0.0);
        }
    }
}

TEST(FractalSum, FloatStaysNearDouble) {
    std::mt19937 random(2);
    const FractalSum fractal{OctaveShape::ridged, 6, 2.0, 0.5, false};
    for (int i = 0; i < 2000; ++i) {
        const Point<3> p = test::random_point<3>(random, 1e5);
        const auto rounded = fractal_sum<float>(fractal, p, [](std::uint32_t k, const Point<3>& q) {
            return sample_noise<float>({.kind = NoiseKind::perlin, .seed = k}, q);
        });
        // Each octave errs by 5e-7 and ridges double that.
        EXPECT_NEAR(rounded.value, sum_of(fractal, p).value, 2.0 * (1e-6 + 1.2e-7));
    }
}

TEST(Field, OfATermIsTheFractalSum) {
    // Texture terms and fractal_sum are two texts of one definition.
    const Point<3> s{0.3, -1.4, 2.7};
    for (const OctaveShape shape : {OctaveShape::plain, OctaveShape::absolute, OctaveShape::ridged})
        for (const bool normalized : {false, true}) {
            Texture texture;
            NoiseTerm& term = texture.noise.emplace_back();
            term.kind = NoiseKind::perlin, term.shape = shape, term.normalized = normalized;
            term.octaves = 4, term.lacunarity = 1.5, term.gain = 0.75;
            const FieldSample f =
                sample_field<double>(texture.quadric, expand_octaves(texture), {s[0], s[1], s[2]});
            const auto sum = sum_of({shape, 4, 1.5, 0.75, normalized}, s);
            EXPECT_NEAR(f.value, sum.value, 1e-13);
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(f.gradient[axis], sum.gradient[std::size_t(axis)], 1e-12);
        }
}

TEST(Field, GradientIsThatOfTheValueThroughQuadricAndMaps) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    Texture texture;
    Quadric& q = texture.quadric;
    for (double* c : {&q.a, &q.b, &q.c, &q.d, &q.e, &q.f, &q.g, &q.h, &q.i, &q.j})
        *c = unit(random);
    for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin, NoiseKind::perlin1985}) {
        NoiseTerm& term = texture.noise.emplace_back();
        term.kind = kind, term.octaves = 2, term.fade = Fade::quintic;
        term.matrix.emplace();
        for (double& m : *term.matrix) m = unit(random);
    }
    const auto octaves = expand_octaves(texture);
    for (int i = 0; i < 200; ++i) {
        const Vec3d s{3.0 * unit(random), 3.0 * unit(random), 3.0 * unit(random)};
        const Vec3d gradient = sample_field<double>(q, octaves, s).gradient;
        const Vec3d rounded = sample_field<float>(q, octaves, s).gradient;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3d step(0.0);
            step[axis] = 1e-5;
            const double slope =
                (evaluate_field(q, octaves, s + step) - evaluate_field(q, octaves, s - step)) /
                2e-5;
            EXPECT_NEAR(gradient[axis], slope, 1e-6 * (1.0 + std::abs(slope)));
            EXPECT_NEAR(rounded[axis], gradient[axis], 3e-5);
        }
    }
}

TEST(Field, WhatIsNeverNegativeHasItsOwnRanges) {
    const Vec3d s(0.4, 1.3, 2.6);
    const double f1 =
        sample_noise<double>({.kind = NoiseKind::worley}, Point<3>{s.x, s.y, s.z}).value;
    Texture texture;
    texture.noise.emplace_back().kind = NoiseKind::worley;
    EXPECT_EQ(evaluate_field(texture, s), f1);
    texture.noise[0].range = NoiseRange::bipolar;
    EXPECT_NEAR(evaluate_field(texture, s), 2.0 * f1 - 1.0, 1e-15);
}

TEST(Field, PeriodsOfOctavesGrowWithTheirFrequency) {
    Texture texture;
    NoiseTerm& term = texture.noise.emplace_back();
    term.kind = NoiseKind::perlin, term.octaves = 4, term.period = {3, 5, 7};
    term.frequency = Vec3d(2.0);
    for (int i = 0; i < 20; ++i) {
        const Vec3d s(0.125 * i, 0.25 * i + 0.0625, 0.375 * i + 0.03125);
        EXPECT_EQ(evaluate_field(texture, s), evaluate_field(texture, s + Vec3d(1.5, -2.5, 7.0)));
        EXPECT_NE(evaluate_field(texture, s + Vec3d(0.01)),
                  evaluate_field(texture, s + Vec3d(1.01, 0.01, 0.01)));
    }
}

}  // namespace
}  // namespace burl
