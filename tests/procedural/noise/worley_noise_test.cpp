#include "procedural/noise/worley_noise.h"

#include <gtest/gtest.h>

#include "procedural/noise/value_noise.h"
#include "tests/procedural/noise/cases.h"

namespace burl {
namespace {

/// The distances to all feature points up to three cells away, sorted.
template <std::size_t N>
std::vector<double> all_distances(const Point<N>& p, std::uint32_t seed) {
    std::vector<double> distances;
    std::array<int, N> steps;
    steps.fill(-3);
    do {
        std::array<std::uint32_t, N> index;
        for (std::size_t i = 0; i < N; ++i)
            index[i] = std::uint32_t(std::int64_t(std::floor(p[i])) + steps[i]);
        const auto place = feature_place<double>(index, seed);
        double square = 0.0;
        for (std::size_t i = 0; i < N; ++i) {
            const double way = std::floor(p[i]) + steps[i] + place[i] - p[i];
            square += way * way;
        }
        distances.push_back(std::sqrt(square));
    } while (next_steps(steps, 3));
    std::sort(distances.begin(), distances.end());
    return distances;
}

template <std::size_t N>
void expect_nearest(int count) {
    std::mt19937 random(1);
    for (int i = 0; i < count; ++i) {
        Point<N> p = test::random_point<N>(random, 50.0);
        if (i % 4 == 0) p[0] = std::floor(p[0]);  // also on faces
        const auto all = all_distances(p, 3);
        EXPECT_NEAR(worley_noise<double>(p, WorleyFeature::f1, 3).value, all[0], 1e-13);
        EXPECT_NEAR(worley_noise<double>(p, WorleyFeature::f2, 3).value, all[1], 1e-13);
        EXPECT_NEAR(worley_noise<double>(p, WorleyFeature::f2_f1, 3).value, all[1] - all[0], 1e-13);
    }
}

TEST(WorleyNoise, IsTheDistanceToTheNearestOfAllPoints) {
    expect_nearest<1>(2000);
    expect_nearest<2>(2000);
    expect_nearest<3>(1000);
    expect_nearest<4>(100);
}

TEST(WorleyNoise, FeaturePointsAreUniformInTheirCells) {
    std::array<double, 3> mean{}, square{};
    double mixed = 0.0;
    constexpr int count = 40000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto place = feature_place<double>(std::array{i, i * 7u, ~i}, 1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            ASSERT_TRUE(place[axis] >= 0.0 && place[axis] < 1.0);
            mean[axis] += place[axis] / count, square[axis] += place[axis] * place[axis] / count;
        }
        mixed += (place[0] - 0.5) * (place[1] - 0.5) / count;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(mean[axis], 0.5, 0.01);
        EXPECT_NEAR(square[axis], 1.0 / 3.0, 0.01);
    }
    EXPECT_NEAR(mixed, 0.0, 0.003);  // axes are drawn independently; 5 sigma is 0.002
}

TEST(CellNoise, IsConstantInACellAndItsLatticeValue) {
    std::mt19937 random(2);
    for (int i = 0; i < 200; ++i) {
        const Point<3> p = test::random_point<3>(random, 100.0);
        std::array<std::uint32_t, 3> index;
        for (std::size_t a = 0; a < 3; ++a)
            index[a] = std::uint32_t(std::int64_t(std::floor(p[a])));
        EXPECT_EQ(cell_noise<double>(p, 5).value, lattice_value(index, 5));
        EXPECT_EQ(double(cell_noise<float>(p, 5).value), lattice_value(index, 5));
    }
}

TEST(WhiteNoise, IsUncorrelatedFromPointToPoint) {
    std::mt19937 random(3);
    constexpr int count = 40000;
    for (const double step : {1.0 / white_cells, 0.001, 0.5, 1.0}) {
        double product = 0.0;
        for (int i = 0; i < count; ++i) {
            Point<3> p = test::random_point<3>(random, 10.0), q = p;
            q[std::size_t(i) % 3] += step;
            product += white_noise<double>(p, 1).value * white_noise<double>(q, 1).value / count;
        }
        EXPECT_NEAR(product, 0.0, 5.0 / 3.0 / 200.0) << step;
    }
}

}  // namespace
}  // namespace burl
