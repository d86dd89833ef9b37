// What docs/reference/noise.md states of every noise: float32's errors, range, mean and variance,
// periods.
#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

using test::NoiseCase;

struct Errors {
    double value = 0.0, gradient = 0.0;
};

/// Largest errors of float32 over random points up to `reach` cells from the origin. Points where
/// the two paths look at different feature points or simplices are left out of the gradient.
template <std::size_t N>
Errors float_errors(const NoiseSpec& noise, double reach, int count) {
    std::mt19937 random(8);
    Errors worst;
    for (int i = 0; i < count; ++i) {
        const Point<N> p = test::random_point<N>(random, reach);
        const auto exact = sample_noise<double>(noise, p);
        const auto rounded = sample_noise<float>(noise, p);
        worst.value = std::max(worst.value, std::abs(exact.value - double(rounded.value)));
        double error = 0.0;
        for (std::size_t axis = 0; axis < N; ++axis)
            error =
                std::max(error, std::abs(exact.gradient[axis] - double(rounded.gradient[axis])));
        if (noise.kind == NoiseKind::worley) error *= std::min(1.0, exact.value);
        worst.gradient = std::max(worst.gradient, error);
    }
    return worst;
}

/// The bounds stated in the kinds' headers.
Errors stated_errors(NoiseKind kind, std::size_t dimensions) {
    switch (kind) {
        case NoiseKind::value:
            return {2.5e-7, 1e-6};
        case NoiseKind::cell:
        case NoiseKind::white:
            return {0.0, 0.0};
        case NoiseKind::simplex:
            if (dimensions != 3) return {1.5e-6, 9e-6};
            [[fallthrough]];
        default:
            return {5e-7, 3e-6};
    }
}

TEST(NoisePrecision, OfFloatIsAsStatedNearAndFar) {
    test::for_each_dimension([]<std::size_t N>(std::integral_constant<std::size_t, N>) {
        for (const NoiseCase& one : test::noise_cases(N))
            for (const double reach : {4.0, 1e6}) {
                const Errors errors = float_errors<N>(one.noise, reach, 4000);
                const Errors stated = stated_errors(one.noise.kind, N);
                EXPECT_LE(errors.value, stated.value) << one.name << " " << N << " " << reach;
                EXPECT_LE(errors.gradient, stated.gradient) << one.name << " " << N << " " << reach;
            }
    });
}

TEST(NoisePrecision, ValuesAloneHaveTheBitsOfValuesWithGradients) {
    std::mt19937 random(13);
    for (const NoiseCase& one : test::noise_cases(3))
        for (int i = 0; i < 200; ++i) {
            const Point<3> p = test::random_point<3>(random, 100.0);
            EXPECT_EQ(noise_value<float>(one.noise, p), sample_noise<float>(one.noise, p).value);
            EXPECT_EQ(noise_value<double>(one.noise, p), sample_noise<double>(one.noise, p).value);
        }
}

/// Bounds of the value, and its mean and variance where points are uniform.
struct Statistics {
    double low = 0.0, high = 0.0, mean = 0.0, variance = 0.0;
};

template <std::size_t N>
Statistics statistics(const NoiseSpec& noise, int count) {
    std::mt19937 random(9);
    Statistics s{1e9, -1e9};
    for (int i = 0; i < count; ++i) {
        const double n = sample_noise<double>(noise, test::random_point<N>(random, 1000.0)).value;
        s.low = std::min(s.low, n), s.high = std::max(s.high, n);
        s.mean += n / count, s.variance += n * n / count;
    }
    s.variance -= s.mean * s.mean;
    return s;
}

/// A row of docs/reference/noise.md's table for three dimensions: bounds that hold, and mean and
/// variance.
struct StatedStatistics {
    const char* name;
    double low, high, mean, variance;
};
constexpr StatedStatistics stated_statistics[] = {{"value linear", -1.0, 1.0, 0.0, 0.099},
                                                  {"value smooth", -1.0, 1.0, 0.0, 0.137},
                                                  {"value quintic", -1.0, 1.0, 0.0, 0.161},
                                                  {"perlin", -1.0364, 1.0364, 0.0, 0.073},
                                                  {"perlin2002", -1.0364, 1.0364, 0.0, 0.073},
                                                  {"perlin1985", -0.8661, 0.8661, 0.0, 0.034},
                                                  {"simplex", -0.348, 0.348, 0.0, 0.0128},
                                                  {"simplex .5", -0.129, 0.129, 0.0, 0.00187},
                                                  {"worley f1", 0.0, 1.7321, 0.520, 0.0297},
                                                  {"worley f2", 0.0, 1.7321, 0.716, 0.0205},
                                                  {"worley f2-f1", 0.0, 1.7321, 0.196, 0.0248},
                                                  {"cell", -1.0, 1.0, 0.0, 0.333},
                                                  {"white", -1.0, 1.0, 0.0, 0.333}};

TEST(NoiseStatistics, AreAsStatedInThreeDimensions) {
    const auto cases = test::noise_cases(3);
    ASSERT_EQ(cases.size(), std::size(stated_statistics));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const StatedStatistics& stated = stated_statistics[i];
        ASSERT_EQ(cases[i].name, stated.name);
        const Statistics s = statistics<3>(cases[i].noise, 40000);
        EXPECT_GE(s.low, stated.low) << stated.name;
        EXPECT_LE(s.high, stated.high) << stated.name;
        // Five standard deviations of the mean of independent points.
        EXPECT_NEAR(s.mean, stated.mean, 0.0006 + 5.0 * std::sqrt(stated.variance) / 200.0)
            << stated.name;
        EXPECT_NEAR(s.variance, stated.variance, 0.05 * stated.variance) << stated.name;
    }
}

TEST(NoiseStatistics, StayWithinTheirBoundsInOtherDimensions) {
    for (const auto& [kind, bound] : {std::pair{NoiseKind::perlin1985, 0.7072},
                                      {NoiseKind::simplex, 1.0},
                                      {NoiseKind::value, 1.0}}) {
        const Statistics s = statistics<2>({.kind = kind}, 20000);
        EXPECT_LE(std::max(-s.low, s.high), bound);
        EXPECT_GE(std::max(-s.low, s.high), 0.9 * bound);
        EXPECT_NEAR(s.mean, 0.0, 0.02);
    }
    for (const auto& [kind, bound] : {std::pair{NoiseKind::perlin, 1.5366},
                                      {NoiseKind::simplex, 1.0},
                                      {NoiseKind::value, 1.0}}) {
        const Statistics s = statistics<4>({.kind = kind}, 20000);
        EXPECT_LE(std::max(-s.low, s.high), bound);
        EXPECT_GE(std::max(-s.low, s.high), 0.5 * bound);
        EXPECT_NEAR(s.mean, 0.0, 0.02);
    }
    const Statistics line = statistics<1>({.kind = NoiseKind::perlin1985}, 20000);
    EXPECT_LE(std::max(-line.low, line.high), 0.5);
}

TEST(NoiseStatistics, ValueNoiseVariesLessWithEveryDimension) {
    // 1/3 times the mean of w^2 + (1 - w)^2 for every axis, by integrating the fade w.
    for (const auto& [fade, factor] : {std::pair{Fade::linear, 2.0 / 3.0},
                                       {Fade::smooth, 26.0 / 35.0},
                                       {Fade::quintic, 181.0 / 231.0}})
        test::for_each_dimension([&, f = fade, per_axis = factor](auto dimensions) {
            constexpr std::size_t n = decltype(dimensions)::value;
            const double stated = std::pow(per_axis, double(n)) / 3.0;
            const Statistics s = statistics<n>({.kind = NoiseKind::value, .fade = f}, 20000);
            EXPECT_NEAR(s.variance, stated, 0.05 * stated) << n;
        });
}

/// Largest value that kernels or slopes with the best of all gradients could add up to at a place:
/// the bounds above must not be exceeded by what another seed draws.
TEST(NoiseStatistics, PerlinsBoundIsReachedByTheBestGradients) {
    double best = 0.0;
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j)
            for (int k = 0; k < 64; ++k) {
                const std::array<double, 3> x{(i + 0.5) / 64, (j + 0.5) / 64, (k + 0.5) / 64};
                double sum = 0.0;
                for (int corner = 0; corner < 8; ++corner) {
                    double weight = 1.0, largest = 0.0, smallest = 1.0;
                    for (std::size_t a = 0; a < 3; ++a) {
                        const bool upper = corner >> a & 1;
                        const double t = x[a], w = t * t * t * (10.0 + t * (6.0 * t - 15.0));
                        weight *= upper ? w : 1.0 - w;
                        const double d = upper ? 1.0 - t : t;
                        largest += d, smallest = std::min(smallest, d);
                    }
                    sum += weight * (largest - smallest);  // the gradient leaves out one axis
                }
                best = std::max(best, sum);
            }
    EXPECT_LE(best, 1.0364);
    EXPECT_GE(best, 1.035);
}

/// A period that the noise can have.
Period<4> some_period(NoiseKind kind) {
    Period<4> period =
        kind == NoiseKind::simplex ? Period<4>{6, 3, 12, 0} : Period<4>{5, 1, 300, 7};
    return period;
}

TEST(NoisePeriod, RepeatsBitForBitAndOnlyThen) {
    test::for_each_dimension([]<std::size_t N>(std::integral_constant<std::size_t, N>) {
        for (NoiseCase one : test::noise_cases(N)) {
            if (!has_period(one.noise.kind, N, 3)) continue;
            one.noise.period = some_period(one.noise.kind);
            std::mt19937 random(10);
            int different = 0;
            for (int i = 0; i < 200; ++i) {
                // Coordinates in steps of 2^-20 stay exact when periods are added.
                Point<N> p = test::random_point<N>(random, 400.0);
                for (double& x : p) x = std::round(x * 0x1p20) * 0x1p-20;
                Point<N> q = p, half = p;
                for (std::size_t axis = 0; axis < N; ++axis)
                    q[axis] += one.noise.period[axis] * (double(random() % 7) - 3.0);
                half[0] += one.noise.period[0] - 1;
                const auto a = sample_noise<double>(one.noise, p),
                           b = sample_noise<double>(one.noise, q);
                ASSERT_EQ(a.value, b.value) << one.name << " " << N;
                ASSERT_EQ(a.gradient, b.gradient) << one.name << " " << N;
                ASSERT_EQ(sample_noise<float>(one.noise, p).value,
                          sample_noise<float>(one.noise, q).value);
                different += a.value != sample_noise<double>(one.noise, half).value;
            }
            EXPECT_GT(different, 150) << one.name << " " << N;
        }
    });
}

TEST(NoisePeriod, IsContinuousWhereItWraps) {
    const double h = 1e-9;
    test::for_each_dimension([h]<std::size_t N>(std::integral_constant<std::size_t, N>) {
        for (NoiseCase one : test::noise_cases(N)) {
            if (!has_period(one.noise.kind, N, 3) || !is_continuous(one, N)) continue;
            one.noise.period = some_period(one.noise.kind);
            std::mt19937 random(11);
            for (int i = 0; i < 300; ++i) {
                Point<N> p = test::random_point<N>(random, 20.0);
                const std::size_t axis = random() % N;
                p[axis] = one.noise.period[axis] * (double(i % 5) - 2.0);
                Point<N> below = p;
                below[axis] -= h;
                EXPECT_NEAR(sample_noise<double>(one.noise, p).value,
                            sample_noise<double>(one.noise, below).value, 8.0 * h)
                    << one.name << " " << N;
            }
        }
    });
}

TEST(NoisePeriod, LeavesTheInsideAlone) {
    // Away from the wrap a periodic noise is the one without period, for kinds that hash cells.
    std::mt19937 random(12);
    for (NoiseCase one : test::noise_cases(3)) {
        const NoiseSpec plain = one.noise;
        one.noise.period = {99, 99, 99, 0};
        for (int i = 0; i < 100; ++i) {
            Point<3> p = test::random_point<3>(random, 12.0);
            for (double& x : p) x += 48.0;
            EXPECT_EQ(sample_noise<double>(plain, p).value,
                      sample_noise<double>(one.noise, p).value)
                << one.name;
        }
    }
}

}  // namespace
}  // namespace burl
