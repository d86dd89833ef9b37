// Levels against sums over the texels of level 0 that each of their texels covers.
#include "atlas/block_levels.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "atlas/mip_chain.h"
#include "made_patches.h"

namespace burl {
namespace {

Image<RgbF> noise(std::uint32_t size) {
    std::mt19937 random(5);
    const auto any = [&] { return float(random() >> 8) * 0x1p-24f; };
    Image<RgbF> image(size, size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (RgbF& p : image.row(y)) p = {any(), any(), any()};
    return image;
}

MeshAtlas atlas_of(const Mesh& mesh, AtlasKind kind, std::uint32_t size) {
    return build_atlas(mesh, build_connectivity(mesh), {.kind = kind, .size = size});
}

bool is_inner(const PatchBlock& block, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t g = block.gutter;
    return x >= block.x + g && x < block.x + block.width - g && y >= block.y + g &&
           y < block.y + block.height - g;
}

bool is_inner(const PatchAtlas& atlas, std::uint32_t x, std::uint32_t y) {
    for (const PatchBlock& block : atlas.layout.blocks)
        if (is_inner(block, x, y)) return true;
    return false;
}

TEST(BlockLevels, AbovePureLevelsOnlyInnerTexelsCount) {
    const MeshAtlas atlas = atlas_of(made::ring(40, 20), AtlasKind::patch, 512);
    ASSERT_TRUE(atlas.patches());
    const std::uint32_t pure = last_pure_level(atlas);
    ASSERT_EQ(pure, 3u);  // gutters of 512 / 128 texels
    const Image<RgbF> texture = noise(512);
    const auto levels = block_levels(atlas, texture, 99);
    ASSERT_EQ(levels.size(), 9u);
    for (const std::uint32_t l : {1u, 3u, 4u, 6u, 9u}) {
        const Image<RgbF>& level = levels[l - 1];
        ASSERT_EQ(level.width(), 512u >> l);
        const std::uint32_t side = 1u << l;
        for (std::uint32_t y = 0; y < level.height(); ++y)
            for (std::uint32_t x = 0; x < level.width(); ++x) {
                double sum = 0.0, count = 0.0;
                for (std::uint32_t j = y * side; j < (y + 1) * side; ++j)
                    for (std::uint32_t i = x * side; i < (x + 1) * side; ++i) {
                        if (l > pure && !is_inner(*atlas.patches(), i, j)) continue;
                        sum += double(texture(i, j).g);
                        count += 1.0;
                    }
                ASSERT_GT(count, 0.0);
                EXPECT_NEAR(level(x, y).g, sum / count, 2e-6) << l << ": " << x << ", " << y;
            }
    }
}

TEST(BlockLevels, PureLevelsMixNoBlocks) {
    for (const AtlasKind kind : {AtlasKind::patch, AtlasKind::quad}) {
        const MeshAtlas atlas = atlas_of(made::box(4), kind, 256);
        // Every block in a grey of its own: a mixture would show another one.
        Image<RgbF> texture(256, 256);
        std::vector<float> greys;
        const auto paint = [&](const auto& block) {
            const float grey = float(greys.size() + 1) / 1024.0f;
            greys.push_back(grey);
            for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
                std::ranges::fill(texture.row(y).subspan(block.x, block.width),
                                  RgbF{grey, grey, grey});
        };
        if (atlas.patches()) {
            for (const PatchBlock& block : atlas.patches()->layout.blocks) paint(block);
        } else {
            for (const Block& block : atlas.atlas().blocks) paint(block);
        }
        const std::uint32_t pure = last_pure_level(atlas);
        ASSERT_GE(pure, 1u);
        for (const Image<RgbF>& level : block_levels(atlas, texture, pure))
            for (const RgbF& p : level.pixels())
                EXPECT_NE(std::find(greys.begin(), greys.end(), p.r), greys.end()) << p.r;
        // And the next one does, unless there is only one block.
        bool mixed = false;
        const std::vector<Image<RgbF>> next = block_levels(atlas, texture, 8);
        for (const RgbF& p : next.back().pixels())
            mixed = mixed || std::find(greys.begin(), greys.end(), p.r) == greys.end();
        EXPECT_EQ(mixed, greys.size() > 1);
    }
}

TEST(BlockLevels, AConstantStaysConstant) {
    for (const AtlasKind kind : {AtlasKind::area, AtlasKind::patch})
        for (const std::uint32_t size : {200u, 256u}) {
            const MeshAtlas atlas = atlas_of(made::tube(24, 20, 6.0), kind, size);
            const Image<RgbF> texture(size, size, {0.25f, 0.5f, 0.75f});
            for (const Image<RgbF>& level : block_levels(atlas, texture, 20))
                for (const RgbF& p : level.pixels()) {
                    EXPECT_NEAR(p.r, 0.25f, 1e-6);
                    EXPECT_NEAR(p.b, 0.75f, 1e-6);
                }
        }
}

TEST(BlockLevels, StripsEndWhereTheNarrowestBlockIsTwoTexelsWide) {
    for (const std::uint32_t size : {64u, 256u, 1024u}) {
        const MeshAtlas atlas = atlas_of(made::one_triangle(), AtlasKind::uniform, size);
        EXPECT_EQ(last_level(atlas), std::uint32_t(std::log2(size)) - 1);
    }
    const MeshAtlas many = atlas_of(made::ring(40, 20), AtlasKind::area, 256);
    std::uint32_t narrowest = 256;
    for (const Block& block : many.atlas().blocks)
        narrowest = std::min({narrowest, block.width, block.height});
    EXPECT_GE(narrowest >> last_level(many), 2u);
    EXPECT_LT(narrowest >> (last_level(many) + 1), 2u);
    EXPECT_EQ(last_level(atlas_of(made::ring(40, 20), AtlasKind::quad, 256)), 8u);
}

}  // namespace
}  // namespace burl
