// Shown shares of masked textures against those of level 0, counted texel by texel.
#include "atlas/build/alpha_levels.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "atlas/build/block_levels.h"
#include "tests/atlas/support/made_atlas.h"
#include "tests/atlas/support/made_patches.h"

namespace burl {
namespace {

/// Soft spots on a transparent ground, few and small where `threshold` is high.
Image<RgbaF> spots(std::uint32_t size, double threshold) {
    Image<RgbaF> image(size, size);
    for (std::uint32_t y = 0; y < size; ++y)
        for (std::uint32_t x = 0; x < size; ++x) {
            const double wave = std::sin(0.31 * x + 0.17 * y) + std::sin(0.23 * x - 0.41 * y) +
                                std::sin(0.05 * x) * std::sin(0.61 * y + 0.02 * x);
            const auto a = float(std::clamp(1.5 * (wave - threshold) + 0.5, 0.0, 1.0));
            image(x, y) = {0.8f * a, 0.25f * a, 0.0f, a};
        }
    return image;
}

/// The share of the surface that a level shows, inside a rectangle of its texels.
double shown(const Image<RgbaF>& level, const Image<float>& weights, float cutoff, std::size_t x0,
             std::size_t y0, std::size_t width, std::size_t height) {
    double sum = 0.0, all = 0.0;
    for (std::size_t y = y0; y < y0 + height; ++y)
        for (std::size_t x = x0; x < x0 + width; ++x) {
            all += double(weights(x, y));
            if (level(x, y).a >= cutoff) sum += double(weights(x, y));
        }
    return sum / all;
}

double shown(const Image<RgbaF>& level, const Image<float>& weights, float cutoff) {
    return shown(level, weights, cutoff, 0, 0, level.width(), level.height());
}

Image<float> weights_of(const MeshAtlas& atlas, std::uint32_t level, std::size_t size) {
    return atlas.patches() ? inner_texels(*atlas.patches(), level) : Image<float>(size, size, 1.0f);
}

TEST(BlendedLevels, RedAndTransparentGreenAreHalfRed) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, 8);
    Image<RgbaF> image(8, 8);
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 8; ++x)
            // A transparent green (0, 1, 0) is (0, 0, 0, 0) once it is multiplied.
            image(x, y) = x % 2 == 0 ? RgbaF{1.0f, 0.0f, 0.0f, 1.0f} : RgbaF{};
    for (const Image<RgbaF>& level : block_levels(atlas, image, 2))
        for (const RgbaF& p : level.pixels()) EXPECT_EQ(p, (RgbaF{0.5f, 0.0f, 0.0f, 0.5f}));
}

TEST(BlendedLevels, FourChannelsAreTheLevelsOfEach) {
    const MeshAtlas atlas = made::atlas_of(made::ring(40, 20), AtlasKind::patch, 256);
    const Image<RgbaF> image = spots(256, 0.2);
    Image<float> opacity(256, 256);
    Image<RgbF> colors(256, 256);
    for (std::size_t y = 0; y < 256; ++y)
        for (std::size_t x = 0; x < 256; ++x) {
            const RgbaF& p = image(x, y);
            opacity(x, y) = p.a, colors(x, y) = {p.r, p.g, p.b};
        }
    const auto both = block_levels(atlas, image, 8);
    const auto of_opacity = block_levels(atlas, opacity, 8);
    const auto of_colors = block_levels(atlas, colors, 8);
    ASSERT_EQ(both.size(), 8u);
    for (std::size_t l = 0; l < 8; ++l)
        for (std::size_t i = 0; i < both[l].pixels().size(); ++i) {
            const RgbaF& p = both[l].pixels()[i];
            EXPECT_EQ(p.a, of_opacity[l].pixels()[i]);
            EXPECT_EQ((RgbF{p.r, p.g, p.b}), of_colors[l].pixels()[i]);
        }
}

TEST(MaskedLevels, ShowAsMuchAsLevel0) {
    for (const AtlasKind kind : {AtlasKind::area, AtlasKind::patch, AtlasKind::quad})
        for (const double threshold : {-0.4, 0.3, 1.3})
            for (const float cutoff : {0.25f, 0.5f, 0.9f}) {
                const MeshAtlas atlas = made::atlas_of(made::ring(40, 20), kind, 512);
                const Image<RgbaF> texture = spots(512, threshold);
                const double share = shown(texture, weights_of(atlas, 0, 512), cutoff);
                ASSERT_GT(share, 0.03);
                const auto levels = masked_levels(atlas, texture, cutoff, 4);
                const auto plain = block_levels(atlas, texture, 4);
                double worst = 0.0;
                for (std::uint32_t l = 1; l <= 4; ++l) {
                    const auto weights = weights_of(atlas, l, levels[l - 1].width());
                    EXPECT_NEAR(shown(levels[l - 1], weights, cutoff), share, 0.005)
                        << l << " " << threshold << " " << cutoff;
                    worst = std::max(worst, std::abs(shown(plain[l - 1], weights, cutoff) - share));
                }
                if (threshold > 1.0) {
                    EXPECT_GT(worst, 0.01) << "plain means would do";
                }
            }
}

TEST(MaskedLevels, EightBitsShowAsMuch) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, 512);
    const Image<RgbaF> texture = spots(512, 0.9);
    const double share = shown(texture, Image<float>(512, 512, 1.0f), 0.5f);
    for (Image<RgbaF>& level : masked_levels(atlas, texture, 0.5f, 3)) {
        for (std::size_t y = 0; y < level.height(); ++y)
            for (RgbaF& p : level.row(y)) p.a = std::round(p.a * 255.0f) / 255.0f;
        EXPECT_NEAR(shown(level, Image<float>(level.width(), level.height(), 1.0f), 0.5f), share,
                    0.005);
    }
}

TEST(MaskedLevels, LargeBlocksOfPatchesKeepTheirOwnShares) {
    const MeshAtlas atlas = made::atlas_of(made::box(4), AtlasKind::patch, 512);
    Image<RgbaF> texture = spots(512, 0.9);
    const Image<float> weights = weights_of(atlas, 0, 512);
    const auto levels = masked_levels(atlas, texture, 0.5f, 2);
    ASSERT_GE(last_pure_level(atlas), 2u);
    std::size_t tested = 0;
    for (const PatchBlock& b : atlas.patches()->layout.blocks)
        for (std::uint32_t l = 1; l <= 2; ++l) {
            if ((b.width >> l) * (b.height >> l) < 1024) continue;
            const double share = shown(texture, weights, 0.5f, b.x, b.y, b.width, b.height);
            const Image<float> at_level = weights_of(atlas, l, 512 >> l);
            EXPECT_NEAR(shown(levels[l - 1], at_level, 0.5f, b.x >> l, b.y >> l, b.width >> l,
                              b.height >> l),
                        share, 0.002);
            ++tested;
        }
    EXPECT_GT(tested, 1u);
}

TEST(MaskedLevels, ColoursStayWhatTheyAreAndOpacitiesAtMostOne) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, 256);
    for (const Image<RgbaF>& level : masked_levels(atlas, spots(256, 1.3), 0.5f, 6))
        for (const RgbaF& p : level.pixels()) {
            EXPECT_LE(p.a, 1.0f);
            EXPECT_NEAR(p.r, 0.8f * p.a, 1e-6);
            EXPECT_NEAR(p.g, 0.25f * p.a, 1e-6);
        }
}

TEST(MaskedLevels, WhatIsWhollyShownOrHiddenIsThePlainMean) {
    const MeshAtlas atlas = made::atlas_of(made::one_triangle(), AtlasKind::uniform, 64);
    for (const double threshold : {-10.0, 10.0}) {
        const Image<RgbaF> texture = spots(64, threshold);
        EXPECT_EQ(masked_levels(atlas, texture, 0.5f, 4), block_levels(atlas, texture, 4));
    }
    const Image<RgbaF> texture = spots(64, 0.5);
    for (const float cutoff : {0.0f, -1.0f, 1.5f, std::nanf("")})
        EXPECT_EQ(masked_levels(atlas, texture, cutoff, 4), block_levels(atlas, texture, 4));
}

}  // namespace
}  // namespace burl
