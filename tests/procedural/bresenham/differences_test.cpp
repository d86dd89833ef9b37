#include "procedural/bresenham/differences.h"

#include <gtest/gtest.h>

#include "procedural/bresenham/cell_polynomial.h"
#include "procedural/noise/noise.h"

namespace burl {
namespace {

TEST(ForwardDifferences, OfAPowerAreFactorialsTimesStirlingNumbers) {
    // Stirling numbers of the second kind S(9, m) and S(15, m) as tables list them.
    const std::array<double, 9> s9{1, 255, 3025, 7770, 6951, 2646, 462, 36, 1};
    const std::array<double, 15> s15{1,         16383,     2375101,   42355950, 210766920,
                                     420693273, 408741333, 216627840, 67128490, 12662650,
                                     1479478,   106470,    4550,      105,      1};
    Powers<9> ninth{};
    ninth[9] = 1.0;
    Powers<15> fifteenth{};
    fifteenth[15] = 1.0;
    const auto d9 = differences_at_zero(ninth);
    const auto d15 = differences_at_zero(fifteenth);
    EXPECT_EQ(d9[0], 0.0);
    double factorial = 1.0;
    for (std::size_t m = 1; m <= 15; ++m) {
        factorial *= double(m);
        if (m <= 9) {
            EXPECT_EQ(d9[m], factorial * s9[m - 1]) << m;
        }
        EXPECT_EQ(d15[m], factorial * s15[m - 1]) << m;
    }
}

TEST(ForwardDifferences, OfACubicAreThoseOfThePaper) {
    const double alpha = 0.5, beta = -2.0, gamma = 3.25, delta = 7.0;
    const auto d = differences_at_zero(Powers<3>{delta, gamma, beta, alpha});
    EXPECT_EQ(d, (Powers<3>{delta, alpha + beta + gamma, 6 * alpha + 2 * beta, 6 * alpha}));
}

/// (x - 1)(x - 2) ... (x - 9) / 9!, exact in all three kinds of numbers after scaling.
Powers<9> falling() {
    Powers<9> p{};
    p[0] = 1.0;
    for (int root = 1; root <= 9; ++root)
        for (std::size_t k = 10; k-- > 0;) p[k] = (k > 0 ? p[k - 1] : 0.0) - root * p[k];
    return p;
}

template <class Number>
void run_falling(int fraction_bits) {
    ForwardDifferences<Number, 9> p(differences_at_zero(falling()), fraction_bits);
    for (int x = 0; x < 14; ++x) {
        double exact = 1.0;
        for (int root = 1; root <= 9; ++root) exact *= x - root;
        EXPECT_EQ(p.value(), exact) << x;
        p.step();
    }
}

TEST(ForwardDifferences, StepThroughWholeNumbersExactly) {
    run_falling<double>(0);
    run_falling<std::int64_t>(0);
    run_falling<std::int64_t>(20);
}

TEST(ForwardDifferences, OfFloatsRoundOnlyThemselves) {
    ForwardDifferences<float, 3> p(differences_at_zero(Powers<3>{0.25, 0.5, -0.125, 0.0625}));
    for (int x = 0; x < 20; ++x) {
        EXPECT_EQ(p.value(), 0.25 + 0.5 * x - 0.125 * x * x + 0.0625 * x * x * x);
        p.step();
    }
}

TEST(CellPolynomial, OfTheLinearFadeIsThePapersCubic) {
    // Kameya & Hart's appendix, s, t, r from the cell's lower corner.
    const std::array<std::int64_t, 3> cell{4, -3, 7};
    const auto n = [&](int i, int j, int k) {
        return evaluate_noise({.fade = Fade::linear, .seed = 9},
                              Vec3d(double(cell[0] + i), double(cell[1] + j), double(cell[2] + k)));
    };
    const double n0 = n(0, 0, 0), n1 = n(1, 0, 0), n2 = n(1, 1, 0), n3 = n(0, 1, 0),
                 n4 = n(0, 0, 1), n5 = n(1, 0, 1), n6 = n(1, 1, 1), n7 = n(0, 1, 1);
    const double a = n0, b = n1 - n0, c = n3 - n0, d = n4 - n0, e = n0 - n1 + n2 - n3,
                 f = n7 - n4 - n3 + n0, g = n5 - n4 - n1 + n0, h = n4 - n5 + n6 - n7 - e;
    const double s = 0.2, t = 0.7, r = 0.4, ds = 0.01, dt = -0.02, dr = 0.005;
    const double alpha = h * ds * dt * dr;
    const double beta =
        e * ds * dt + f * dt * dr + g * dr * ds + h * (s * dt * dr + t * dr * ds + r * ds * dt);
    const double gamma = b * ds + c * dt + d * dr + e * (s * dt + t * ds) + f * (t * dr + r * dt) +
                         g * (r * ds + s * dr) + h * (s * r * dt + t * r * ds + s * t * dr);
    const double delta =
        a + b * s + c * t + d * r + e * s * t + f * t * r + g * r * s + h * s * t * r;
    const Powers<3> ours = noise_along<Fade::linear>(
        cell_blend(cell, 9), Vec3d(s - 0.5, t - 0.5, r - 0.5), Vec3d(ds, dt, dr));
    EXPECT_NEAR(ours[0], delta, 1e-15);
    EXPECT_NEAR(ours[1], gamma, 1e-16);
    EXPECT_NEAR(ours[2], beta, 1e-18);
    EXPECT_NEAR(ours[3], alpha, 1e-20);
}

template <Fade fade>
void expect_noise_along_lines() {
    const Vec3d lower(-5.0, 2.0, 11.0);
    const CellBlend blend = cell_blend({-5, 2, 11}, 3);
    for (const Vec3d from : {Vec3d(-0.5, -0.5, -0.5), Vec3d(0.1, -0.3, 0.5), Vec3d(0.0)}) {
        const Vec3d step = (Vec3d(0.5, 0.4, -0.5) - from) / 16.0;
        const auto n = noise_along<fade>(blend, from, step);
        for (int j = 0; j <= 16; ++j) {
            double value = 0.0;
            for (std::size_t k = n.size(); k-- > 0;) value = value * j + n[k];
            const Vec3d place = from + double(j) * step;
            const double exact = evaluate_noise({.fade = fade, .seed = 3}, lower + 0.5 + place);
            EXPECT_NEAR(value, exact, 1e-12);
            EXPECT_NEAR(blend_at(blend, fade, place), exact, 1e-14);
        }
    }
}

TEST(CellPolynomial, IsTheNoiseAlongALine) {
    expect_noise_along_lines<Fade::linear>();
    expect_noise_along_lines<Fade::smooth>();
    expect_noise_along_lines<Fade::quintic>();
}

}  // namespace
}  // namespace burl
