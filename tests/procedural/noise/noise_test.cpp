#include "procedural/noise/noise.h"

#include <array>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "procedural/noise/perlin_noise.h"
#include "procedural/noise/value_noise.h"

namespace burl {
namespace {

TEST(PerlinNoise, GivesThePublishedValues) {
    EXPECT_NEAR(published_perlin_noise({3.14, 42, 7}), 0.13691995878400012, 1e-15);
    EXPECT_EQ(published_perlin_noise({0, 0, 0}), 0.0);
    EXPECT_NEAR(published_perlin_noise({-4.20, 10.0, 6.0}), 0.14208000000000043, 1e-14);
}

TEST(PerlinNoise, GradientsAreTheEdgesOfACubeAndOfAHypercube) {
    std::set<std::array<double, 3>> edges;
    for (std::uint32_t g = 0; g < 16; ++g) {
        const auto v = perlin_gradient<double, 3>(g);
        EXPECT_EQ(v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 2.0);
        edges.insert(v);
    }
    EXPECT_EQ(edges.size(), 12u);
    std::set<std::array<double, 4>> edges4;
    for (std::uint32_t g = 0; g < 32; ++g) {
        const auto v = perlin_gradient<double, 4>(g);
        EXPECT_EQ(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3], 3.0);
        edges4.insert(v);
    }
    EXPECT_EQ(edges4.size(), 32u);
}

TEST(PerlinNoise, VanishesOnTheLatticeAndHasTheGradientThere) {
    for (int i = -3; i < 3; ++i) {
        const Point<3> p{double(i), 2.0 * i + 1.0, 5.0 - i};
        const std::array<std::uint32_t, 3> index{std::uint32_t(i), std::uint32_t(2 * i + 1),
                                                 std::uint32_t(5 - i)};
        const auto n = sample_noise<double>({.kind = NoiseKind::perlin, .seed = 9}, p);
        EXPECT_EQ(n.value, 0.0);
        const auto expected = perlin_gradient<double, 3>(lattice_gradient(index, 9));
        EXPECT_EQ(n.gradient, expected);
    }
}

TEST(ValueNoise, IsTheLatticeValueOnTheLattice) {
    for (int i = -5; i < 5; ++i)
        for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic})
            EXPECT_EQ(evaluate_noise({.kind = NoiseKind::value, .fade = fade, .seed = 3},
                                     Vec3d(i, 7, -i)),
                      lattice_value(std::uint32_t(i), 7u, std::uint32_t(-i), 3));
}

TEST(ValueNoise, InterpolatesWithTheFade) {
    // Along an edge of the lattice, by the fades' own formulas.
    const double a = lattice_value(4, 1, 2, 0), b = lattice_value(5, 1, 2, 0);
    for (const double x : {0.1, 0.25, 0.5, 0.9}) {
        const double smooth = 3 * x * x - 2 * x * x * x;
        const double quintic = 6 * std::pow(x, 5) - 15 * std::pow(x, 4) + 10 * std::pow(x, 3);
        const Vec3d p(4 + x, 1, 2);
        EXPECT_NEAR(evaluate_noise({.kind = NoiseKind::value, .fade = Fade::linear, .seed = 0}, p),
                    a + x * (b - a), 4e-15);
        EXPECT_NEAR(evaluate_noise({.kind = NoiseKind::value, .fade = Fade::smooth, .seed = 0}, p),
                    a + smooth * (b - a), 4e-15);
        EXPECT_NEAR(evaluate_noise({.kind = NoiseKind::value, .fade = Fade::quintic, .seed = 0}, p),
                    a + quintic * (b - a), 4e-15);
    }
    // In the middle of a cell it is the mean of the corners.
    double mean = 0.0;
    for (std::uint32_t c = 0; c < 8; ++c)
        mean += lattice_value(10 + (c & 1), 20 + (c >> 1 & 1), 30 + (c >> 2), 0) / 8.0;
    EXPECT_NEAR(evaluate_noise({.kind = NoiseKind::value, .fade = Fade::smooth, .seed = 0},
                               {10.5, 20.5, 30.5}),
                mean, 1e-15);
}

TEST(Noise, IsContinuousAcrossCellFaces) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-100.0, 100.0);
    const double h = 1e-9;
    for (int i = 0; i < 3000; ++i) {
        Vec3d p{coordinate(random), coordinate(random), coordinate(random)};
        p[i % 3] = std::round(p[i % 3]);
        Vec3d below = p;
        below[i % 3] -= h;
        for (const NoiseKind kind : {NoiseKind::value, NoiseKind::perlin})
            for (const Fade fade : {Fade::linear, Fade::smooth, Fade::quintic})
                EXPECT_NEAR(evaluate_noise({.kind = kind, .fade = fade, .seed = 5}, p),
                            evaluate_noise({.kind = kind, .fade = fade, .seed = 5}, below), 4 * h);
    }
}

TEST(Noise, WrapsTheLatticeAndIgnoresHopelessCoordinates) {
    const Vec3d p(0.3, 0.7, 0.1);
    const Vec3d far = p + Vec3d(4294967296.0, 0, 0);
    EXPECT_NEAR(evaluate_noise({.kind = NoiseKind::value, .fade = Fade::smooth, .seed = 0}, far),
                evaluate_noise({.kind = NoiseKind::value, .fade = Fade::smooth, .seed = 0}, p),
                1e-5);
    for (const double huge : {1e300, -1e300, 1e18, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(evaluate_noise({.kind = NoiseKind::value, .fade = Fade::smooth, .seed = 0},
                                 {huge, 0.7, 0.1}),
                  evaluate_noise({.kind = NoiseKind::value, .fade = Fade::smooth, .seed = 0},
                                 {0.0, 0.7, 0.1}));
}

TEST(LatticeGradients, AreEquallyFrequent) {
    std::array<int, 16> histogram{};
    for (std::uint32_t k = 0; k < 40; ++k)
        for (std::uint32_t j = 0; j < 40; ++j)
            for (std::uint32_t i = 0; i < 40; ++i)
                ++histogram[lattice_gradient(std::array{i, j, k}, 2)];
    double chi_squared = 0.0;
    for (const int n : histogram) chi_squared += (n - 4000.0) * (n - 4000.0) / 4000.0;
    EXPECT_LT(chi_squared, 15 + 5 * 5.5);
}

}  // namespace
}  // namespace burl
