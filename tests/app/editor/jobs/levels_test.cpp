// Levels for OpenGL against means in linear light, worked out in float64.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "app/editor/jobs/levels.h"
#include "procedural/color/srgb.h"

namespace burl {
namespace {

Image<Rgb8> random_texels(std::size_t width, std::size_t height) {
    std::mt19937 random(7);
    Image<Rgb8> texels(width, height);
    const auto code = [&] { return std::uint8_t(random() >> 24); };
    for (std::size_t y = 0; y < height; ++y)
        for (Rgb8& texel : texels.row(y)) texel = {code(), code(), code()};
    return texels;
}

/// The code of the mean of four, not rounded.
double mean_code(const Image<Rgba8>& fine, std::size_t x, std::size_t y,
                 std::uint8_t Rgba8::*channel) {
    double sum = 0.0;
    for (const std::size_t row : {2 * y, 2 * y + 1})
        for (const std::size_t column : {2 * x, 2 * x + 1})
            sum += srgb_decode(
                fine(std::min(column, fine.width() - 1), std::min(row, fine.height() - 1)).*
                    channel /
                255.0);
    return 255.0 * srgb_encode(0.25 * sum);
}

TEST(EditLevels, AreMeansInLinearLight) {
    const Image<Rgb8> texels = random_texels(64, 32);
    const std::vector<Image<Rgba8>> levels = EditLevels()(texels);
    ASSERT_EQ(levels.size(), 7u);
    for (std::size_t l = 1; l < levels.size(); ++l) {
        ASSERT_EQ(levels[l].width(), 64u >> l);
        ASSERT_EQ(levels[l].height(), std::max(32u >> l, 1u));
        for (std::size_t y = 0; y < levels[l].height(); ++y)
            for (std::size_t x = 0; x < levels[l].width(); ++x)
                for (const auto c : {&Rgba8::r, &Rgba8::g, &Rgba8::b})
                    EXPECT_LE(std::abs(levels[l](x, y).*c - mean_code(levels[l - 1], x, y, c)),
                              0.5 + 0.025);
    }
}

TEST(EditLevels, TheFinestIsTheTextureAndOneColourStaysIt) {
    const Image<Rgb8> texels = random_texels(16, 16);
    const std::vector<Image<Rgba8>> levels = EditLevels()(texels);
    for (std::size_t y = 0; y < 16; ++y)
        for (std::size_t x = 0; x < 16; ++x)
            EXPECT_EQ(levels[0](x, y),
                      (Rgba8{texels(x, y).r, texels(x, y).g, texels(x, y).b, 255}));
    for (int code = 0; code < 256; ++code) {
        const auto c = std::uint8_t(code);
        EXPECT_EQ(EditLevels()(Image<Rgb8>(4, 4, {c, c, c})).back()(0, 0), (Rgba8{c, c, c, 255}));
    }
}

/// Data are averaged as they are, and alpha always.
TEST(EditLevels, NumbersAndAlphaAreMeansOfCodes) {
    Image<Rgba8> texels(2, 2);
    texels(0, 0) = {0, 10, 255, 0}, texels(1, 0) = {100, 10, 255, 255};
    texels(0, 1) = {200, 30, 0, 40}, texels(1, 1) = {50, 30, 0, 60};
    const Rgba8 data = EditLevels()(texels, false).at(1)(0, 0);
    EXPECT_EQ(data, (Rgba8{88, 20, 128, 89}));
    const Rgba8 color = EditLevels()(texels, true).at(1)(0, 0);
    EXPECT_EQ(color.a, 89);
    EXPECT_NEAR(color.b, 255.0 * srgb_encode(0.5), 0.55);
}

TEST(EditLevels, OtherSidesThanPowersOfTwoHaveNone) {
    EXPECT_EQ(EditLevels()(random_texels(48, 48)).size(), 1u);
}

}  // namespace
}  // namespace burl
