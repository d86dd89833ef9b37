// Blocks tile the square, follow the demand, and lie on the grid their gutters need.
#include "atlas/patch_layout.h"

#include <gtest/gtest.h>

#include <random>

namespace burl {
namespace {

/// A flat patch of these sides: X = A w^2, Y = A h^2.
PatchDemand flat(double width, double height, const Vec3d& centre = Vec3d(0.0)) {
    const double area = width * height;
    return {{area * width * width, area * height * height, area}, area, centre};
}

std::vector<PatchDemand> random_patches(std::size_t count, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0.2, 1.0);
    std::vector<PatchDemand> patches;
    for (std::size_t i = 0; i < count; ++i)
        patches.push_back(flat(any(random), any(random), {any(random), any(random), any(random)}));
    return patches;
}

void expect_tiles(const PatchLayout& layout, std::uint32_t size) {
    std::vector<std::uint8_t> seen(std::size_t{size} * size, 0);
    for (const PatchBlock& b : layout.blocks) {
        ASSERT_LE(b.x + b.width, size);
        ASSERT_LE(b.y + b.height, size);
        for (std::uint32_t y = b.y; y < b.y + b.height; ++y)
            for (std::uint32_t x = b.x; x < b.x + b.width; ++x) ++seen[std::size_t{y} * size + x];
    }
    EXPECT_EQ(seen, std::vector<std::uint8_t>(seen.size(), 1));
}

TEST(PatchLayout, TilesTheSquareOnItsGrid) {
    for (const std::size_t count : {1u, 2u, 7u, 30u, 150u})
        for (const std::uint32_t size : {256u, 300u, 1024u}) {
            const auto patches = random_patches(count, std::uint32_t(count));
            const auto layout = layout_patches(patches, {.size = size, .gutter = {}, .tries = 4});
            ASSERT_TRUE(layout);
            expect_tiles(*layout, size);
            for (const PatchBlock& b : layout->blocks) {
                EXPECT_EQ(b.x % (2 * layout->gutter), 0u);
                EXPECT_EQ(b.y % (2 * layout->gutter), 0u);
                EXPECT_LE(b.gutter, layout->gutter);
                EXPECT_LE(4 * b.gutter, std::min(b.width, b.height));
            }
        }
}

TEST(PatchLayout, TexelsFollowTheOptimalBudget) {
    // For two flat patches of areas a and b the error sum A^2/K is least for K ~ A.
    EXPECT_NEAR(texel_demand(flat(2.0, 3.0)) / texel_demand(flat(1.0, 1.0)), 6.0, 1e-9);
    std::vector<PatchDemand> patches;
    for (std::uint32_t i = 0; i < 4; ++i)
        patches.push_back(flat(1.0 + (i & 1), 1.0, {double(i & 1), double(i >> 1), 0.0}));
    const auto layout = layout_patches(patches, {.size = 1024, .gutter = 4, .tries = 8});
    ASSERT_TRUE(layout);
    double all = 0.0, area = 0.0;
    for (const PatchDemand& p : patches) area += p.area;
    for (const PatchBlock& b : layout->blocks) all += double(b.columns()) * b.rows();
    for (std::size_t i = 0; i < 4; ++i) {
        const PatchBlock& b = layout->blocks[i];
        EXPECT_NEAR(double(b.columns()) * b.rows() / all, patches[i].area / area, 0.03);
    }
}

TEST(PatchLayout, PredictsTheStretchItCauses) {
    // One square patch without a gutter: border to border 1023 of 1024 texels.
    const std::vector<PatchDemand> one{flat(3.0, 3.0)};
    const auto layout = layout_patches(one, {.size = 1024, .gutter = 0, .tries = 1});
    ASSERT_TRUE(layout);
    EXPECT_NEAR(layout->predicted_stretch, (1024.0 / 1023.0) * (1024.0 / 1023.0), 1e-12);
    const auto patches = random_patches(12, 5);
    const auto more = layout_patches(patches, {.size = 512, .gutter = 4, .tries = 8});
    const auto fewer = layout_patches(patches, {.size = 512, .gutter = 4, .tries = 1});
    ASSERT_TRUE(more && fewer);
    EXPECT_LE(more->predicted_stretch, fewer->predicted_stretch);
    EXPECT_LT(more->predicted_stretch, 2.0);
    EXPECT_GT(more->predicted_stretch, 1.0);
}

TEST(PatchLayout, TurnsLongPatchesToFit) {
    const std::vector<PatchDemand> patches{flat(1.0, 8.0, {0, 0, 0}), flat(8.0, 1.0, {1, 0, 0})};
    const auto layout = layout_patches(patches, {.size = 512, .gutter = 4, .tries = 1});
    ASSERT_TRUE(layout);
    EXPECT_NE(layout->blocks[0].turned, layout->blocks[1].turned);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(layout->blocks[i].aspect() < 1.0, i == 0);
    for (const PatchBlock& b : layout->blocks) {
        // The corners of the unit square go to the centres of the outermost inner texels, in the
        // same turning sense.
        const Vec2d a = b.place({0, 0}), u = b.place({1, 0}) - a, v = b.place({0, 1}) - a;
        EXPECT_GT(u.x * v.y - u.y * v.x, 0.0);
        const Vec2d low = glm::min(a, a + u + v), high = glm::max(a, a + u + v);
        EXPECT_EQ(low, Vec2d(b.x + b.gutter + 0.5, b.y + b.gutter + 0.5));
        EXPECT_EQ(high, Vec2d(b.x + b.width - b.gutter - 0.5, b.y + b.height - b.gutter - 0.5));
    }
}

TEST(PatchLayout, HalvesTheGutterUntilPatchesFit) {
    const auto patches = random_patches(100, 9);
    const auto layout = layout_patches(patches, {.size = 64, .gutter = 8, .tries = 2});
    ASSERT_TRUE(layout);
    EXPECT_LT(layout->gutter, 8u);
    expect_tiles(*layout, 64);
    EXPECT_FALSE(layout_patches(patches, {.size = 16, .gutter = 8, .tries = 2}));
    EXPECT_FALSE(layout_patches({}, {}));
}

TEST(PatchLayout, SameEveryTime) {
    const auto patches = random_patches(40, 13);
    const auto a = layout_patches(patches, {}), b = layout_patches(patches, {});
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->blocks, b->blocks);
}

}  // namespace
}  // namespace burl
