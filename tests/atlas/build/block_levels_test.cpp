// Levels against sums over the texels of level 0 that each of their texels covers.
#include "atlas/build/block_levels.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "atlas/base/mip_chain.h"
#include "atlas/read/read_mesh.h"
#include "tests/atlas/support/made_atlas.h"
#include "tests/atlas/support/made_patches.h"
#include "tests/paths.h"

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

/// A level's texel against level 0.
void expect_means(const MeshAtlas& atlas, const Image<RgbF>& texture, const Image<RgbF>& level,
                  std::uint32_t number) {
    const std::uint32_t side = 1u << number;
    const Image<float> inner = inner_texels(*atlas.patches());
    const bool all = number <= last_pure_level(atlas);
    for (std::uint32_t y = 0; y < level.height(); ++y)
        for (std::uint32_t x = 0; x < level.width(); ++x) {
            double sum = 0.0, count = 0.0;
            for (std::uint32_t j = y * side; j < (y + 1) * side; ++j)
                for (std::uint32_t i = x * side; i < (x + 1) * side; ++i) {
                    if (!all && inner(i, j) == 0.0f) continue;
                    sum += double(texture(i, j).g);
                    count += 1.0;
                }
            if (count == 0.0) continue;
            EXPECT_NEAR(level(x, y).g, sum / count, 2e-6) << number << ": " << x << ", " << y;
        }
}

/// Whether a block's surface ends off the multiples of the layout's gutter.
bool ends_anywhere(const PatchLayout& layout) {
    return std::ranges::any_of(layout.blocks, [&](const PatchBlock& b) {
        const std::uint32_t g = layout.gutter;
        return (b.x + b.gutter) % g != 0 || (b.x + b.width - b.gutter) % g != 0 ||
               (b.y + b.gutter) % g != 0 || (b.y + b.height - b.gutter) % g != 0;
    });
}

TEST(BlockLevels, AbovePureLevelsOnlyInnerTexelsCount) {
    const MeshAtlas ring = made::atlas_of(made::ring(40, 20), AtlasKind::patch, 512);
    const MeshAtlas teapot = made::atlas_of(read_mesh(test::binary_folder() + "/meshes/teapot.obj"),
                                            AtlasKind::patch, 1024);
    ASSERT_EQ(last_pure_level(ring), 3u);  // gutters of 512 / 128 texels
    ASSERT_TRUE(ends_anywhere(teapot.patches()->layout));
    for (const MeshAtlas* atlas : {&ring, &teapot}) {
        const std::uint32_t size = atlas->atlas().options.size;
        const Image<RgbF> texture = noise(size);
        const auto levels = block_levels(*atlas, texture, 99);
        ASSERT_EQ(size >> levels.size(), 1u);
        for (std::uint32_t l = 1; l <= levels.size(); ++l) {
            ASSERT_EQ(levels[l - 1].width(), size >> l);
            expect_means(*atlas, texture, levels[l - 1], l);
        }
    }
}

/// Every block in a grey of its own: a mixture shows another one.
struct PaintedBlocks {
    Image<RgbF> texture;
    std::vector<float> greys;

    explicit PaintedBlocks(const MeshAtlas& atlas)
        : texture(atlas.atlas().options.size, atlas.atlas().options.size) {
        if (atlas.patches()) {
            for (const PatchBlock& block : atlas.patches()->layout.blocks) paint(block);
        } else {
            for (const Block& block : atlas.atlas().blocks) paint(block);
        }
    }
    template <class AnyBlock>
    void paint(const AnyBlock& block) {
        const float grey = float(greys.size() + 1) / 1024.0f;
        greys.push_back(grey);
        for (std::uint32_t y = block.y; y < block.y + block.height; ++y)
            std::ranges::fill(texture.row(y).subspan(block.x, block.width), RgbF{grey, grey, grey});
    }
    /// Greys have few bits, so means of one of them are exact; what no block covers is 0.
    bool mixes(const Image<RgbF>& level) const {
        for (const RgbF& p : level.pixels())
            if (p.r != 0.0f && std::find(greys.begin(), greys.end(), p.r) == greys.end())
                return true;
        return false;
    }
};

TEST(BlockLevels, PureLevelsMixNoBlocks) {
    struct Case {
        AtlasKind kind;
        std::uint32_t size, least;
    };
    // With 384 texels gutters are 3 wide and blocks lie on multiples of 6.
    for (const auto& [kind, size, least] :
         {Case{AtlasKind::patch, 256, 1}, Case{AtlasKind::patch, 384, 1},
          Case{AtlasKind::quad, 256, 1}}) {
        const MeshAtlas atlas = made::atlas_of(made::box(4), kind, size);
        const PaintedBlocks blocks(atlas);
        const std::uint32_t pure = last_pure_level(atlas);
        ASSERT_GE(pure, least);
        for (const Image<RgbF>& level : block_levels(atlas, blocks.texture, pure))
            EXPECT_FALSE(blocks.mixes(level)) << size;
        // And the last does, unless there is only one block.
        EXPECT_EQ(blocks.mixes(block_levels(atlas, blocks.texture, 99).back()),
                  blocks.greys.size() > 1);
    }
}

TEST(BlockLevels, GoOnFromAnyLevelThatKeepsGuttersApart) {
    const MeshAtlas atlas = made::atlas_of(made::ring(40, 20), AtlasKind::patch, 512);
    ASSERT_TRUE(atlas.patches());
    ASSERT_EQ(last_pure_level(atlas), 3u);
    const auto whole = block_levels(atlas, noise(512), 9);
    for (const std::uint32_t first : {1u, 2u}) {  // gutters are 4 texels wide
        const auto rest = block_levels(atlas, whole[first - 1], 9, first);
        ASSERT_EQ(rest.size(), 9u - first);
        for (std::uint32_t l = first + 1; l <= 9; ++l) {
            const Image<RgbF>&expected = whole[l - 1], &level = rest[l - first - 1];
            ASSERT_EQ(level.width(), expected.width());
            for (std::size_t i = 0; i < level.pixels().size(); ++i)
                EXPECT_NEAR(level.pixels()[i].g, expected.pixels()[i].g, 1e-6) << first << l;
        }
    }
    EXPECT_TRUE(block_levels(atlas, whole[8], 9, 9).empty());
}

TEST(BlockLevels, SharesOfSurfaceAreMeansOfInnerTexels) {
    for (const std::uint32_t size : {512u, 300u}) {
        const MeshAtlas atlas = made::atlas_of(made::ring(40, 20), AtlasKind::patch, size);
        ASSERT_TRUE(atlas.patches());
        const Image<float> all = inner_texels(*atlas.patches());
        for (const std::uint32_t level : {1u, 2u, 3u, 4u}) {
            const Image<float> shares = inner_texels(*atlas.patches(), level);
            ASSERT_EQ(shares.width(), size >> level);
            const double scale = double(size) / double(shares.width());
            for (std::uint32_t y = 0; y < shares.height(); ++y)
                for (std::uint32_t x = 0; x < shares.width(); ++x) {
                    double sum = 0.0;  // over texels, by the share of them that is covered
                    const auto part = [&](std::uint32_t i, std::uint32_t at) {
                        return std::max(0.0, std::min(i + 1.0, (at + 1) * scale) -
                                                 std::max(double(i), at * scale));
                    };
                    for (auto j = std::uint32_t(y * scale); j < size && j < (y + 1) * scale; ++j)
                        for (auto i = std::uint32_t(x * scale); i < size && i < (x + 1) * scale;
                             ++i)
                            sum += part(i, x) * part(j, y) * double(all(i, j));
                    EXPECT_NEAR(shares(x, y), sum / (scale * scale), 1e-6) << x << ", " << y;
                }
        }
    }
}

TEST(BlockLevels, AConstantStaysConstant) {
    for (const AtlasKind kind : {AtlasKind::area, AtlasKind::patch})
        for (const std::uint32_t size : {200u, 256u}) {
            const MeshAtlas atlas = made::atlas_of(made::tube(24, 20, 6.0), kind, size);
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
        const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, size);
        EXPECT_EQ(last_level(atlas), std::uint32_t(std::log2(size)) - 1);
    }
    const MeshAtlas many = made::atlas_of(made::ring(40, 20), AtlasKind::area, 256);
    std::uint32_t narrowest = 256;
    for (const Block& block : many.atlas().blocks)
        narrowest = std::min({narrowest, block.width, block.height});
    EXPECT_GE(narrowest >> last_level(many), 2u);
    EXPECT_LT(narrowest >> (last_level(many) + 1), 2u);
    EXPECT_EQ(last_level(made::atlas_of(made::ring(40, 20), AtlasKind::quad, 256)), 8u);
}

}  // namespace
}  // namespace burl
