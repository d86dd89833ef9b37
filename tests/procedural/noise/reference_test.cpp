// Perlin's published functions against values of other implementations.
#include <gtest/gtest.h>

#include "procedural/noise/noise.h"
#include "procedural/noise/perlin1985.h"
#include "tests/procedural/noise/reference_values.h"

namespace burl {
namespace {

TEST(SimplexNoise, GivesTheValuesOfAppendixB) {
    const NoiseSpec noise{.kind = NoiseKind::simplex};
    for (const auto& [x, y, z, n] : test::simplex_values) {
        EXPECT_NEAR(sample_noise<double>(noise, Point<3>{x, y, z}).value, n, 1e-12);
        EXPECT_NEAR(sample_noise<float>(noise, Point<3>{x, y, z}).value, n, 1e-6);
    }
}

TEST(Perlin1985, GivesTheValuesOfAppendixA) {
    const NoiseSpec noise{.kind = NoiseKind::perlin1985};
    for (const auto& [x, y, z, n] : test::classic_values) {
        EXPECT_NEAR(sample_noise<double>(noise, Point<3>{x, y, z}).value, n, 1e-12);
        EXPECT_NEAR(sample_noise<float>(noise, Point<3>{x, y, z}).value, n, 5e-7);
    }
}

TEST(Perlin1985, FillsTheTablesOfAppendixA) {
    const ClassicTables& tables = classic_tables();
    for (const auto& [i, p, g] : test::classic_entries) {
        EXPECT_EQ(tables.p[i], p);
        for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(tables.g3[i][axis], g[axis], 1e-9);
    }
    std::array<int, 256> seen{};
    for (const std::uint32_t p : tables.p) ++seen[p];
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 256);
    EXPECT_NE(ClassicTables(2).p, tables.p);
}

TEST(Perlin1985, OneAndTwoDimensionsFollowTheTables) {
    // Halfway along an edge the s-curve is 1/2: n = (g0 / 2 - g1 / 2) / 2.
    const ClassicTables& t = classic_tables();
    const NoiseSpec noise{.kind = NoiseKind::perlin1985};
    for (const std::uint32_t i : {0u, 7u, 254u}) {
        const double expected = 0.25 * (double(t.g1[t.p[i]][0]) - double(t.g1[t.p[i + 1]][0]));
        EXPECT_NEAR(sample_noise<double>(noise, Point<1>{i + 0.5}).value, expected, 1e-15);
        const std::uint32_t low = t.p[(t.p[i] + 20) & 255], high = t.p[(t.p[i + 1] + 20) & 255];
        EXPECT_NEAR(sample_noise<double>(noise, Point<2>{i + 0.5, 20.0}).value,
                    0.25 * (double(t.g2[low][0]) - double(t.g2[high][0])), 1e-15);
    }
}

TEST(PublishedPerlin, IsTheKindPerlin2002) {
    const auto n = sample_noise<double>({.kind = NoiseKind::perlin2002}, Point<3>{3.14, 42, 7});
    EXPECT_NEAR(n.value, 0.13691995878400012, 1e-15);
    EXPECT_NE(
        sample_noise<double>({.kind = NoiseKind::perlin2002, .seed = 1}, Point<3>{3.14, 42, 7})
            .value,
        n.value);
}

}  // namespace
}  // namespace burl
