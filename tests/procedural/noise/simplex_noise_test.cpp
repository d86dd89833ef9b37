#include "procedural/noise/simplex_noise.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

/// The definition without any splitting: all corners of the lattice near p, each with its kernel.
/// With radius^2 0.5 a kernel ends where its simplices do, so this is the noise itself.
template <std::size_t N>
double by_all_corners(const Point<N>& p) {
    using Shape = SimplexShape<N>;
    const double skew = (Shape::stretch - 1.0) / double(N), unskew = skew / Shape::stretch;
    double sum = 0.0, coordinates = 0.0;
    for (const double x : p) coordinates += x;
    std::array<std::int64_t, N> base, steps;
    for (std::size_t i = 0; i < N; ++i)
        base[i] = std::int64_t(std::floor(p[i] + skew * coordinates));
    for (std::size_t code = 0; code < std::size_t(std::pow(5.0, double(N)) + 0.5); ++code) {
        std::size_t digits = code;
        double total = 0.0;
        std::array<std::uint32_t, N> index;
        for (std::size_t i = 0; i < N; ++i, digits /= 5) {
            steps[i] = base[i] + std::int64_t(digits % 5) - 2;
            index[i] = std::uint32_t(steps[i]);
            total += double(steps[i]);
        }
        double t = 0.5, slope = 0.0;
        const auto g = Shape::template gradient<double>(Shape::hash(index, 0));
        for (std::size_t i = 0; i < N; ++i) {
            const double d = p[i] - (double(steps[i]) - unskew * total);
            t -= d * d, slope += g[i] * d;
        }
        if (t > 0) sum += t * t * t * t * slope;
    }
    return Shape::amplitude * sum;
}

TEST(SimplexNoise, IsTheSumOfAllKernels) {
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
        const auto p2 = test::random_point<2>(random, 30.0);
        EXPECT_NEAR(simplex_noise<double>(p2, 0).value, by_all_corners(p2), 1e-11);
        const auto p3 = test::random_point<3>(random, 30.0);
        EXPECT_NEAR(simplex_noise<double>(p3, 0, 0.5).value, by_all_corners(p3), 1e-12);
        const auto p4 = test::random_point<4>(random, 30.0);
        EXPECT_NEAR(simplex_noise<double>(p4, 0).value, by_all_corners(p4), 1e-11);
    }
}

TEST(SimplexNoise, VanishesAtLatticePointsWhoseNeighboursAreTooFar) {
    // Skewed (i,j,k) lies at i - (i+j+k)/6; only its own kernel reaches it at radius^2 0.5.
    for (int i = -4; i < 4; ++i)
        for (int j = -4; j < 4; ++j) {
            const double back = (i + j + 1) / 6.0;
            EXPECT_NEAR(simplex_noise<double>(Point<3>{i - back, j - back, 1 - back}, 0, 0.5).value,
                        0.0, 1e-14);
        }
}

TEST(SimplexNoise, JumpsAsLittleAsThePapersRadiusAllows) {
    // With 0.6 a kernel reaches beyond the simplices round its corner.
    std::mt19937 random(2);
    double largest = 0.0;
    for (int i = 0; i < 40000; ++i) {
        Point<3> p = test::random_point<3>(random, 20.0);
        p[0] = p[1] + std::round(p[0] - p[1]);
        Point<3> below = p;
        below[0] -= 1e-9;
        largest = std::max(largest, std::abs(simplex_noise<double>(p, 0).value -
                                             simplex_noise<double>(below, 0).value));
    }
    EXPECT_LT(largest, 2e-3);
    EXPECT_GT(largest, 1e-4);  // else radius2 0.6 was not what was asked
}

/// How often neighbours share their gradient, over the number expected of random ones (for 2500 of
/// 20000 five standard deviations are 9 %, for 625 20 %).
template <std::size_t N>
double worst_coincidence(std::uint32_t gradients) {
    using Shape = SimplexShape<N>;
    std::mt19937 random(3);
    double worst = 0.0;
    for (std::size_t axis = 0; axis < N; ++axis)
        for (const std::uint32_t lag : {1u, 2u}) {
            int same = 0;
            constexpr int count = 20000;
            for (int i = 0; i < count; ++i) {
                std::array<std::uint32_t, N> a;
                for (auto& x : a) x = random() & 255;
                auto b = a;
                b[axis] += lag;
                same += Shape::template gradient<double>(Shape::hash(a, 0)) ==
                        Shape::template gradient<double>(Shape::hash(b, 0));
            }
            worst = std::max(worst, double(same) / count * gradients);
        }
    return worst;
}

TEST(SimplexHash, SharesGradientsBetweenNeighboursAsOftenAsByChance) {
    EXPECT_LT(worst_coincidence<2>(8), 1.1);
    EXPECT_LT(worst_coincidence<3>(16), 1.4);
    EXPECT_LT(worst_coincidence<4>(32), 1.25);
}

TEST(SimplexHash, UsesEveryGradient) {
    std::mt19937 random(4);
    std::set<std::array<double, 2>> two;
    std::set<std::array<double, 3>> three;
    std::set<std::array<double, 4>> four;
    for (std::uint32_t h = 0; h < 64; ++h) {
        two.insert(SimplexShape<2>::gradient<double>(h));
        three.insert(SimplexShape<3>::gradient<double>(h));
        four.insert(SimplexShape<4>::gradient<double>(h));
    }
    EXPECT_EQ(two.size(), 8u);
    EXPECT_EQ(three.size(), 20u);  // 12 edges and 8 corners of the cube
    EXPECT_EQ(four.size(), 32u);
}

}  // namespace
}  // namespace burl
