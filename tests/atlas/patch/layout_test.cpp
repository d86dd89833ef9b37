// Blocks tile the square, follow the demand, and lie on the grid their gutters need.
#include "atlas/patch/layout.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "atlas/patch/tree.h"

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
    for (std::size_t i = 0; i < count; ++i) {
        const double width = any(random), height = any(random);
        patches.push_back(flat(width, height, {any(random), any(random), any(random)}));
    }
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

TEST(PatchBudget, BlocksFillTheSquareWithInnerTexelsInProportion) {
    for (const std::size_t count : {1u, 5u, 200u})
        for (const std::uint32_t gutter : {0u, 2u, 8u}) {
            const auto patches = random_patches(count, 7);
            const auto texels = block_texels(patches, 1024, gutter);
            EXPECT_NEAR(std::accumulate(texels.begin(), texels.end(), 0.0), 1024.0 * 1024.0, 1.0);
            // Undo the gutter and the border of a block that is as wide as its patch wants.
            double least = 1e300, most = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                const double a = patches[i].stretch.best_aspect(), g = 1.0 + 2.0 * gutter;
                // (s sqrt(a) + g) (s / sqrt(a) + g) = texels, for s
                const double b = g * (std::sqrt(a) + 1.0 / std::sqrt(a)), c = g * g - texels[i];
                const double s = 0.5 * (-b + std::sqrt(b * b - 4.0 * c));
                least = std::min(least, s * s / texel_demand(patches[i]));
                most = std::max(most, s * s / texel_demand(patches[i]));
            }
            EXPECT_NEAR(most / least, 1.0, 1e-6) << count << ' ' << gutter;
        }
}

TEST(PatchTree, KnowsWhatDivisionsCost) {
    // Two flat squares side by side on 64 x 32 texels get 32 x 32 each, 31 steps; on 32 x 64 too.
    const std::vector<PatchDemand> two{flat(1.0, 1.0), flat(1.0, 1.0, {1, 0, 0})};
    const std::vector<double> texels{1024.0, 1024.0};
    const std::vector<Vec3d> centres{two[0].centre, two[1].centre};
    const auto nodes = build_patch_tree(patch_leaves(two, texels, 0), centres);
    ASSERT_EQ(nodes.size(), 3u);
    const double alone = 2.0 / (31.0 * 31.0);
    EXPECT_NEAR(nodes[0].estimate(32.0, 32.0), alone, 1e-12);
    EXPECT_EQ(nodes[2].leaves, 2u);
    const double squareness = 1.02;  // of the estimate, for one octave
    EXPECT_NEAR(nodes[2].estimate(64.0, 32.0), 2.0 * alone * squareness, 1e-12);
    EXPECT_NEAR(nodes[2].estimate(32.0, 64.0), 2.0 * alone * squareness, 1e-12);
    EXPECT_GT(nodes[2].estimate(256.0, 8.0), 2.0 * nodes[2].estimate(64.0, 32.0));
}

TEST(PatchLayout, ManyPatchesKeepNearTheirBudget) {
    const auto patches = random_patches(1500, 21);
    const auto layout = layout_patches(patches, {.size = 1024, .gutter = {}, .tries = 8});
    ASSERT_TRUE(layout);
    expect_tiles(*layout, 1024);
    // 700 texels each with gutters as wide as at 12 patches would waste most of them.
    EXPECT_LT(layout->gutter, 8u);
    EXPECT_GE(layout->gutter, 1u);
    EXPECT_LT(layout->predicted_stretch, 3.0);
}

TEST(PatchLayout, SameEveryTime) {
    const auto patches = random_patches(40, 13);
    const auto a = layout_patches(patches, {}), b = layout_patches(patches, {});
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->blocks, b->blocks);
}

}  // namespace
}  // namespace burl
