// Simplex noises in many dimensions and their curl against the sum over all lattice points near the
// point, in long double, against differences, and against closed forms of their moments.
#include "procedural/noise/simplex_signal.h"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "procedural/noise/simplex_curl.h"
#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

using Real = long double;
constexpr std::size_t most = most_simplex_dimensions;
constexpr std::array signals{SimplexSignal::gradient, SimplexSignal::value, SimplexSignal::wave};

Real skew_of(std::size_t n) {
    return (std::sqrt(Real(n) + 1) - 1) / Real(n);
}
Real unskew_of(std::size_t n) {
    return (1 - 1 / std::sqrt(Real(n) + 1)) / Real(n);
}

/// Calls visit(corner, d, t) for all 4^N lattice points round the skewed cube of p within the
/// kernel's radius, in no order that has to do with simplices.
template <std::size_t N, class Visit>
void for_all_corners(const Point<N>& p, const Visit& visit) {
    Real coordinates = 0;
    for (const double x : p) coordinates += x;
    std::array<std::int64_t, N> base, corner;
    for (std::size_t i = 0; i < N; ++i)
        base[i] = std::int64_t(std::floor(p[i] + skew_of(N) * coordinates));
    for (std::size_t code = 0; code < std::size_t(1) << 2 * N; ++code) {
        Real total = 0, t = 0.5L;
        for (std::size_t i = 0; i < N; ++i) {
            corner[i] = base[i] + std::int64_t(code >> 2 * i & 3) - 1;
            total += Real(corner[i]);
        }
        std::array<Real, N> d;
        for (std::size_t i = 0; i < N; ++i) {
            d[i] = p[i] - (Real(corner[i]) - unskew_of(N) * total);
            t -= d[i] * d[i];
        }
        if (t > 0) visit(corner, d, t);
    }
}

template <std::size_t N>
Real by_all_corners(const SimplexNoise& noise, std::uint32_t seed, const Point<N>& p) {
    Real sum = 0;
    for_all_corners(p, [&](const auto& corner, const std::array<Real, N>& d, Real t) {
        const std::uint32_t bits = simplex_bits(corner, seed);
        const auto g = simplex_direction<double, N>(bits);
        Real along = 0;
        for (std::size_t i = 0; i < N; ++i) along += g[i] * d[i];
        const Real number = Real(bits >> 8) / 0x1p23L;
        const Real s = noise.signal == SimplexSignal::gradient ? along
                       : noise.signal == SimplexSignal::value
                           ? (number < 1 ? number : number - 2)
                           : std::sin(2 * std::numbers::pi_v<Real> * Real(noise.waves) * along);
        sum += std::pow(t, Real(4)) * s;
    });
    return sum;
}

/// Calls check.operator()<N>() for all dimensions.
template <class Check>
void in_all_dimensions(const Check& check) {
    [&]<std::size_t... k>(std::index_sequence<k...>) {
        (check.template operator()<k + 2>(), ...);
    }
    (std::make_index_sequence<most - 1>());
}

TEST(SimplexSignal, IsTheSumOfAllKernels) {
    std::mt19937 random(1);
    in_all_dimensions([&]<std::size_t N>() {
        double size = 0.0;
        for (int i = 0; i < (N < 6 ? 200 : 30); ++i) {
            const Point<N> p = test::random_point<N>(random, 30.0);
            for (const SimplexSignal signal : signals) {
                const SimplexNoise noise{N, signal, 1.3};
                const double n = simplex_signal<double, N>(noise, 5, p).value;
                size = std::max(size, std::abs(n));
                EXPECT_NEAR(n, double(by_all_corners(noise, 5, p)), 1e-14) << N;
            }
        }
        EXPECT_GT(size, 1e-4) << N;
    });
}

/// A random point on a border of simplices: where a skewed coordinate is whole, or where two have
/// the same fraction.
template <std::size_t N>
Point<N> border_point(std::mt19937& random, bool whole) {
    Point<N> y = test::random_point<N>(random, 20.0);
    y[0] = std::round(y[0]) + (whole ? 0.0 : y[1] - std::floor(y[1]));
    double sum = 0.0;
    for (const double x : y) sum += x;
    for (double& x : y) x -= double(unskew_of(N)) * sum;
    return y;
}

TEST(SimplexSignal, GoesOnAcrossBordersOfSimplices) {
    std::mt19937 random(2);
    in_all_dimensions([&]<std::size_t N>() {
        for (int i = 0; i < 500; ++i) {
            Point<N> low = border_point<N>(random, i % 2 == 0), high = low;
            low[0] -= 1e-9, high[0] += 1e-9;
            for (const SimplexSignal signal : signals) {
                const SimplexNoise noise{N, signal, 1.0};
                const auto a = simplex_signal<double, N>(noise, 3, low);
                const auto b = simplex_signal<double, N>(noise, 3, high);
                EXPECT_NEAR(a.value, b.value, 3e-9) << N;
                for (std::size_t axis = 0; axis < N; ++axis)
                    EXPECT_NEAR(a.gradient[axis], b.gradient[axis], 2e-8) << N;
            }
        }
    });
}

TEST(SimplexSignal, GradientsAgreeWithDifferences) {
    std::mt19937 random(3);
    in_all_dimensions([&]<std::size_t N>() {
        double size = 0.0;
        for (int i = 0; i < 100; ++i) {
            const Point<N> p = test::random_point<N>(random, 20.0);
            const SimplexNoise noise{N, signals[std::size_t(i) % 3], 0.7};
            const auto n = simplex_signal<double, N>(noise, 8, p);
            for (std::size_t axis = 0; axis < N; ++axis) {
                const auto at = [&](double step) {
                    Point<N> q = p;
                    q[axis] += step;
                    return simplex_signal<double, N>(noise, 8, q).value;
                };
                const double h = 1e-3;
                const double slope = (at(-2 * h) - 8 * at(-h) + 8 * at(h) - at(2 * h)) / (12 * h);
                size = std::max(size, std::abs(slope));
                EXPECT_NEAR(n.gradient[axis], slope, 1e-9) << N;
            }
        }
        EXPECT_GT(size, 1e-3) << N;
    });
}

TEST(SimplexSignal, KernelsHaveTheirIntegrals) {
    for (std::size_t n = 2; n <= most; ++n)
        for (const int power : {6, 8}) {
            const double half = 0.5 * double(n);
            const double integral = std::pow(std::numbers::pi, half) * std::pow(0.5, half + power) *
                                    std::tgamma(power + 1.0) / std::tgamma(half + power + 1.0);
            EXPECT_NEAR(simplex_kernel_integral(n, power) / integral, 1.0, 1e-13) << n;
        }
}

/// Mean and standard deviation of numbers.
struct Moments {
    double sum = 0.0, squares = 0.0, count = 0.0;
    void add(double x) { sum += x, squares += x * x, count += 1.0; }
    double mean() const { return sum / count; }
    double deviation() const { return std::sqrt(squares / count - mean() * mean()); }
};

TEST(SimplexSignal, MeansAndDeviationsAreTheSameInAllDimensions) {
    std::mt19937 random(4);
    for (std::size_t n = 2; n <= most; ++n)
        for (const SimplexSignal signal : signals) {
            const SimplexNoise noise{n, signal,
                                     signal == SimplexSignal::wave ? 0.2 * double(n) : 1.0};
            const double amplitude = noise.amplitude();
            Moments moments;
            for (int i = 0; i < 60000; ++i) {
                const auto p = test::random_point<most>(random, 1000.0);
                moments.add(amplitude * sample_simplex<float>(noise, 6, p).value);
            }
            EXPECT_NEAR(moments.mean(), 0.0, 0.005) << n;
            EXPECT_NEAR(moments.deviation(), 0.25, 0.012) << n << " " << int(signal);
        }
}

TEST(SimplexSignal, DirectionsAreUnitVectorsOfNoPreference) {
    std::mt19937 random(5);
    in_all_dimensions([&]<std::size_t N>() {
        std::array<std::array<double, N>, N> sums{};
        const int count = 40000;
        for (int i = 0; i < count; ++i) {
            const auto corner = test::random_point<N>(random, 1e6);
            std::array<std::int64_t, N> index;
            for (std::size_t k = 0; k < N; ++k) index[k] = std::int64_t(corner[k]);
            const auto g = simplex_direction<double, N>(simplex_bits(index, 7));
            double length = 0.0;
            for (const double x : g) length += x * x;
            EXPECT_NEAR(length, 1.0, 1e-15);
            for (std::size_t a = 0; a < N; ++a)
                for (std::size_t b = 0; b < N; ++b) sums[a][b] += g[a] * g[b];
        }
        for (std::size_t a = 0; a < N; ++a)
            for (std::size_t b = 0; b < N; ++b)
                EXPECT_NEAR(sums[a][b] / count, a == b ? 1.0 / double(N) : 0.0, 0.015) << N;
    });
}

TEST(SimplexSignal, NeighboursAreIndependent) {
    // Neighbours in every direction, the last coordinate's included, share no random number.
    in_all_dimensions([&]<std::size_t N>() {
        for (std::size_t axis = 0; axis < N; ++axis) {
            double products = 0.0;
            for (int i = 0; i < 20000; ++i) {
                std::array<std::int64_t, N> corner{};
                corner[0] = i % 150, corner[N - 1] += i / 150;
                const auto number = [&] {
                    return double(std::int32_t(simplex_bits(corner, 1))) * 0x1p-31;
                };
                const double here = number();
                corner[axis] += 1;
                products += here * number();
            }
            EXPECT_NEAR(products / 20000, 0.0, 0.012) << N << " " << axis;
        }
    });
}

TEST(SimplexSignal, Float32IsAsExactAsItsHeaderSays) {
    std::mt19937 random(6);
    for (std::size_t n = 2; n <= most; ++n)
        for (const SimplexSignal signal : signals) {
            const SimplexNoise noise{n, signal, 1.0};
            double value = 0.0, slope = 0.0;
            for (int i = 0; i < 20000; ++i) {
                const auto p = test::random_point<most>(random, 1e5);
                const auto a = sample_simplex<float>(noise, 2, p);
                const auto b = sample_simplex<double>(noise, 2, p);
                value = std::max(value, std::abs(a.value - b.value));
                for (std::size_t k = 0; k < n; ++k)
                    slope = std::max(slope, std::abs(a.gradient[k] - b.gradient[k]));
            }
            EXPECT_LT(value, signal == SimplexSignal::gradient ? 1.5e-8 : 7e-8) << n;
            EXPECT_LT(slope, 5e-7) << n;
        }
}

/// The potential whose curl the field is, by all corners.
template <std::size_t N>
std::array<Real, 3> potential(std::uint32_t seed, const Point<N>& p) {
    std::array<Real, 3> sum{};
    for_all_corners(p, [&](const auto& corner, const auto&, Real t) {
        const auto r = simplex_direction<double, 3>(simplex_bits(corner, seed));
        for (std::size_t a = 0; a < 3; ++a) sum[a] += t * t * t * t * r[a];
    });
    return sum;
}

template <std::size_t N>
void expect_curl_of_potential(std::mt19937& random) {
    for (int i = 0; i < 100; ++i) {
        const Point<N> p = test::random_point<N>(random, 20.0);
        const double h = 1e-3;
        const auto slope = [&](std::size_t component, std::size_t axis) {
            const auto at = [&](double step) {
                Point<N> q = p;
                q[axis] += step;
                return potential(4, q)[component];
            };
            return double((at(-2 * h) - 8 * at(-h) + 8 * at(h) - at(2 * h)) / (12 * h));
        };
        const FieldVector<double> field = simplex_curl<double, N>(4, p);
        EXPECT_NEAR(field.value[0], slope(2, 1) - slope(1, 2), 1e-9);
        EXPECT_NEAR(field.value[1], slope(0, 2) - slope(2, 0), 1e-9);
        EXPECT_NEAR(field.value[2], slope(1, 0) - slope(0, 1), 1e-9);
    }
}

TEST(SimplexCurl, IsTheCurlOfItsPotential) {
    std::mt19937 random(7);
    expect_curl_of_potential<3>(random);
    expect_curl_of_potential<4>(random);
}

TEST(SimplexCurl, HasNoDivergenceAndExactDerivatives) {
    std::mt19937 random(8);
    double size = 0.0;
    for (int i = 0; i < 400; ++i) {
        const Point<3> p = test::random_point<3>(random, 20.0);
        const std::optional<double> time = i % 2 ? std::optional(0.37 * i) : std::nullopt;
        const FieldVector<double> field = sample_curl<double>(9, p, time);
        EXPECT_NEAR(field.slope[0][0] + field.slope[1][1] + field.slope[2][2], 0.0, 1e-15);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto at = [&](double step, std::size_t a) {
                Point<3> q = p;
                q[axis] += step;
                return sample_curl<double>(9, q, time).value[a];
            };
            for (std::size_t a = 0; a < 3; ++a) {
                const double h = 1e-4;
                const double slope =
                    (at(-2 * h, a) - 8 * at(-h, a) + 8 * at(h, a) - at(2 * h, a)) / (12 * h);
                size = std::max(size, std::abs(slope));
                EXPECT_NEAR(field.slope[a][axis], slope, 1e-7);
            }
        }
    }
    EXPECT_GT(size, 0.05);
}

TEST(SimplexCurl, Float32IsAsExactAsItsHeaderSays) {
    std::mt19937 random(10);
    double value = 0.0, slope = 0.0;
    for (int i = 0; i < 40000; ++i) {
        const Point<3> p = test::random_point<3>(random, 1e5);
        const std::optional<double> time = i % 2 ? std::optional(0.01 * i) : std::nullopt;
        const auto a = sample_curl<float>(2, p, time), b = sample_curl<double>(2, p, time);
        for (std::size_t k = 0; k < 3; ++k) {
            value = std::max(value, std::abs(a.value[k] - b.value[k]));
            for (std::size_t axis = 0; axis < 3; ++axis)
                slope = std::max(slope, std::abs(a.slope[k][axis] - b.slope[k][axis]));
        }
    }
    EXPECT_LT(value, 3e-7);
    EXPECT_LT(slope, 2e-6);
    EXPECT_GT(value, 1e-9);
}

TEST(SimplexCurl, HasTheStatedSize) {
    std::mt19937 random(9);
    for (const bool timed : {false, true}) {
        const double amplitude = simplex_curl_amplitude(timed ? 4 : 3);
        double squares = 0.0, largest = 0.0;
        const int count = 200000;
        for (int i = 0; i < count; ++i) {
            const Point<3> p = test::random_point<3>(random, 1000.0);
            const auto field =
                sample_curl<float>(3, p, timed ? std::optional(0.01 * i) : std::nullopt);
            for (const double x : field.value) {
                squares += amplitude * amplitude * x * x;
                largest = std::max(largest, amplitude * std::abs(x));
            }
        }
        EXPECT_NEAR(squares / count, 1.0, 0.02);
        EXPECT_LT(largest, 3.0);  // what app/recipe/lattice_check.cpp counts on
        EXPECT_GT(largest, 1.0);
    }
}

}  // namespace
}  // namespace burl
