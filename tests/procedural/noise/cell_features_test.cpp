// Cells round feature points against brute force over all points that could count.
#include "procedural/noise/cell_features.h"

#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "atlas/base/vec.h"

namespace burl {
namespace {

std::vector<Vec3d> random_points(std::size_t count, double reach, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-reach, reach);
    std::vector<Vec3d> points(count);
    for (Vec3d& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
    return points;
}

Vec3d feature_of(const std::array<std::int64_t, 3>& cube, const CellPoints& points) {
    const std::uint32_t h = LatticeHash::bits(std::uint32_t(cube[0]), std::uint32_t(cube[1]),
                                              std::uint32_t(cube[2]), points.seed);
    Vec3d feature;
    for (int axis = 0; axis < 3; ++axis)
        feature[axis] = double(cube[std::size_t(axis)]) + 0.5 +
                        points.jitter * (hash_number(h, std::uint32_t(axis)) - 0.5);
    return feature;
}

/// The distance to the nearest of all feature points in cubes up to six away, and to the nearest
/// plane between it and another.
std::pair<double, double> counted_cell(const Vec3d& x, const CellPoints& points) {
    std::vector<Vec3d> features;
    for (int i = -6; i <= 6; ++i)
        for (int j = -6; j <= 6; ++j)
            for (int k = -6; k <= 6; ++k)
                features.push_back(feature_of(
                    {std::int64_t(std::floor(x.x)) + i, std::int64_t(std::floor(x.y)) + j,
                     std::int64_t(std::floor(x.z)) + k},
                    points));
    const Vec3d* nearest = &features[0];
    for (const Vec3d& q : features)
        if (glm::distance(x, q) < glm::distance(x, *nearest)) nearest = &q;
    double edge = 1e9;
    for (const Vec3d& q : features)
        if (&q != nearest)
            edge = std::min(edge, glm::dot(0.5 * (*nearest + q) - x, glm::normalize(q - *nearest)));
    return {glm::distance(x, *nearest), edge};
}

TEST(Cells, DistancesAreThoseOfAllFeaturePoints) {
    std::uint32_t seed = 0;
    for (const double jitter : {0.0, 0.3, 0.9, 1.0})
        for (const Vec3d& x : random_points(jitter == 1.0 ? 3000 : 500, 20.0, 5)) {
            const CellPoints points{seed++ % 97, jitter};
            const auto [distance, edge] = counted_cell(x, points);
            const Point<3> p{x.x, x.y, x.z};
            EXPECT_NEAR(cell_feature(p, points, CellGives::distance).value, distance, 1e-13);
            EXPECT_NEAR(cell_feature(p, points, CellGives::edge).value, edge, 1e-12);
        }
    // Without jitter cells are unit cubes.
    const CellPoints cubes{3, 0.0};
    EXPECT_NEAR(cell_feature({0.1, 0.7, 5.4}, cubes, CellGives::edge).value, 0.1, 1e-15);
    EXPECT_NEAR(cell_feature({0.3, 0.5, -0.9}, cubes, CellGives::distance).value,
                std::hypot(0.2, 0.4), 1e-15);
}

TEST(Cells, IdsChangeAtTheBorderAndNowhereElse) {
    const CellPoints points;
    const auto at = [&](const Vec3d& p, CellGives gives) {
        return cell_feature({p.x, p.y, p.z}, points, gives);
    };
    std::set<double> ids;
    for (const Vec3d& p : random_points(2000, 20.0, 7)) {
        const NoiseSample<double, 3> edge = at(p, CellGives::edge);
        const Vec3d slope(edge.gradient[0], edge.gradient[1], edge.gradient[2]);
        const double number = at(p, CellGives::id).value;
        EXPECT_NEAR(glm::length(slope), 1.0, 1e-12);
        ids.insert(number);
        EXPECT_GE(number, 0.0);
        EXPECT_LT(number, 1.0);
        EXPECT_NE(at(p - (edge.value + 1e-9) * slope, CellGives::id).value, number);
        for (const Vec3d& q : random_points(4, 1.0, std::uint32_t(ids.size())))
            EXPECT_EQ(at(p + 0.999999 * edge.value * glm::normalize(q), CellGives::id).value,
                      number);
    }
    EXPECT_GT(ids.size(), 1800u);
    EXPECT_NEAR(std::accumulate(ids.begin(), ids.end(), 0.0) / double(ids.size()), 0.5, 0.03);
}

}  // namespace
}  // namespace burl
