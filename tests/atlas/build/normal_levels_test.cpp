// Levels of normals against closed forms: normals without spread, two lobes, and slopes of known
// covariance.
#include "atlas/build/normal_levels.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "atlas/build/block_levels.h"
#include "tests/atlas/support/made_atlas.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

RgbF unit(double x, double y, double z) {
    const double length = std::sqrt(x * x + y * y + z * z);
    return {float(x / length), float(y / length), float(z / length)};
}

/// The normal of a surface with these slopes.
RgbF sloped(double x, double y) {
    return unit(-x, -y, 1.0);
}

double alpha_squared(float roughness) {
    return std::pow(double(roughness), 4.0);
}

TEST(NormalLevels, EqualNormalsKeepDirectionAndRoughness) {
    for (const AtlasKind kind : {AtlasKind::area, AtlasKind::patch})
        for (const std::uint32_t size : {200u, 256u})
            for (const auto& [normal, rough] : {std::pair{RgbF{0.0f, 0.0f, 1.0f}, 0.05f},
                                                {unit(0.3, -0.8, 1.0), 0.1f},
                                                {unit(3.0, 1.0, -0.2), 1.0f}}) {
                const MeshAtlas atlas = made::atlas_of(made::tube(24, 20, 6.0), kind, size);
                const auto levels = normal_levels(atlas, Image<RgbF>(size, size, normal),
                                                  Image<float>(size, size, rough), 20);
                ASSERT_GE(levels.size(), 7u);
                for (const NormalLevel& level : levels)
                    for (std::size_t i = 0; i < level.normals.pixels().size(); ++i) {
                        const RgbF& n = level.normals.pixels()[i];
                        EXPECT_NEAR(n.r, normal.r, 5e-7);
                        EXPECT_NEAR(n.g, normal.g, 5e-7);
                        EXPECT_NEAR(n.b, normal.b, 5e-7);
                        EXPECT_NEAR(alpha_squared(level.roughness.pixels()[i]),
                                    alpha_squared(rough), 1e-6);
                        if (normal.b == 1.0f) {
                            EXPECT_NEAR(level.roughness.pixels()[i], rough, 3e-8);
                        }
                    }
            }
}

TEST(NormalLevels, RoughnessAloneIsItsMean) {
    const MeshAtlas atlas = made::atlas_of(made::ring(40, 20), AtlasKind::patch, 256);
    Image<float> roughness(256, 256);
    std::mt19937 random(2);
    for (std::size_t y = 0; y < 256; ++y)
        for (float& r : roughness.row(y)) r = float(random() >> 8) * 0x1p-24f;
    const auto levels =
        normal_levels(atlas, Image<RgbF>(256, 256, RgbF{0.0f, 0.0f, 1.0f}), roughness, 8);
    const auto means = block_levels(atlas, roughness, 8);
    ASSERT_EQ(levels.size(), 8u);
    for (std::size_t l = 0; l < 8; ++l) EXPECT_EQ(levels[l].roughness, means[l]) << l;
}

TEST(NormalLevels, TwoLobesGiveTheVarianceOfTheirSlopes) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, 64);
    for (const double slope : {1e-3, 0.01, 0.1, 0.5, 2.0})
        for (const float rough : {0.0f, 0.1f, 0.5f}) {
            Image<RgbF> normals(64, 64);
            for (std::size_t y = 0; y < 64; ++y)
                for (std::size_t x = 0; x < 64; ++x)
                    normals(x, y) = sloped((x + y) % 2 == 0 ? slope : -slope, 0.0);
            const auto levels = normal_levels(atlas, normals, Image<float>(64, 64, rough), 3);
            ASSERT_EQ(levels.size(), 3u);
            for (const NormalLevel& level : levels) {
                EXPECT_NEAR(level.normals(3, 2).r, 0.0f, 1e-7);
                EXPECT_NEAR(level.normals(3, 2).b, 1.0f, 1e-7);
                // The mean of (+-s, 0, 1) / sqrt(1 + s^2) has the length 1 / sqrt(1 + s^2).
                const double added = 2.0 * (std::sqrt(1.0 + slope * slope) - 1.0);
                const double expected = std::min(alpha_squared(rough) + added, 1.0);
                EXPECT_NEAR(alpha_squared(level.roughness(3, 2)), expected, 2e-6 * expected)
                    << slope;
                // Olano and Baker's: alpha^2 grows by twice the variance per axis, s^2 / 2.
                if (slope < 0.2) {
                    EXPECT_NEAR(added, slope * slope, 0.26 * std::pow(slope, 4.0));
                }
            }
        }
}

TEST(NormalLevels, SlopesOfAGaussianAddTwiceTheirVariancePerAxis) {
    // To first order; Beckmann's alpha^2 is twice the variance per axis of a surface's slopes.
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, 512);
    std::mt19937 random(8);
    std::normal_distribution<double> bell(0.0, 0.05);
    Image<RgbF> normals(512, 512);
    for (std::size_t y = 0; y < 512; ++y)
        for (RgbF& n : normals.row(y)) n = sloped(bell(random), bell(random));
    const auto levels = normal_levels(atlas, normals, Image<float>(512, 512, 0.3f), 8);
    ASSERT_EQ(levels.size(), 8u);
    const double added = alpha_squared(levels[7].roughness(1, 1)) - alpha_squared(0.3f);
    EXPECT_NEAR(added, 2.0 * 0.05 * 0.05, 0.02 * 2.0 * 0.05 * 0.05);
}

TEST(NormalLevels, OpposedAndMissingNormalsAreRoughAndFlat) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, 8);
    Image<RgbF> normals(8, 8, RgbF{1.0f, 0.0f, 0.0f});
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 8; x += 2) normals(x, y).r = -1.0f;
    const auto opposed = normal_levels(atlas, normals, Image<float>(8, 8, 0.2f), 1);
    EXPECT_EQ(opposed.at(0).normals(1, 1), (RgbF{0.0f, 0.0f, 1.0f}));
    EXPECT_EQ(opposed.at(0).roughness(1, 1), 1.0f);
    const auto missing = normal_levels(atlas, Image<RgbF>(8, 8), Image<float>(8, 8, 0.2f), 1);
    EXPECT_EQ(missing.at(0).normals(1, 1), (RgbF{0.0f, 0.0f, 1.0f}));
    EXPECT_EQ(missing.at(0).roughness(1, 1), 0.2f);
}

}  // namespace
}  // namespace burl
