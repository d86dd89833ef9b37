// Levels against closed forms: means, steps, ramps and the exact overlap of odd sizes.
#include "atlas/base/mip_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace burl {
namespace {

Image<float> mip_chain_noise(std::size_t width, std::size_t height) {
    std::mt19937 random(7);
    Image<float> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (float& value : image.row(y)) value = float(random() % 4096) / 4096.0f;
    return image;
}

double mean(const Image<float>& image) {
    double sum = 0.0;
    for (const float value : image.pixels()) sum += double(value);
    return sum / double(image.pixels().size());
}

TEST(MipChain, SizesAreHalvedDownToOneTexel) {
    const auto sizes = [](std::size_t width, std::size_t height) {
        std::vector<std::pair<std::size_t, std::size_t>> result;
        for (const Image<float>& level : build_mip_chain(Image<float>(width, height)).levels)
            result.push_back({level.width(), level.height()});
        return result;
    };
    using Sizes = std::vector<std::pair<std::size_t, std::size_t>>;
    EXPECT_EQ(sizes(8, 8), (Sizes{{8, 8}, {4, 4}, {2, 2}, {1, 1}}));
    EXPECT_EQ(sizes(7, 7), (Sizes{{7, 7}, {3, 3}, {1, 1}}));
    EXPECT_EQ(sizes(100, 3), (Sizes{{100, 3}, {50, 1}, {25, 1}, {12, 1}, {6, 1}, {3, 1}, {1, 1}}));
    EXPECT_EQ(sizes(1, 1), (Sizes{{1, 1}}));
}

TEST(MipChain, EveryLevelKeepsTheMean) {
    // Multiples of 2^-12 halve exactly: with powers of two the mean is the same number.
    const MipChain<float> even = build_mip_chain(mip_chain_noise(64, 64));
    for (std::size_t l = 0; l < 5; ++l) EXPECT_EQ(mean(even.levels[l]), mean(even.levels[0])) << l;
    EXPECT_NEAR(mean(even.levels.back()), mean(even.levels[0]), 1e-7);
    for (const auto& [width, height] : {std::pair{63u, 63u}, {37u, 100u}, {5u, 1u}, {21u, 64u}})
        for (const Image<float>& level : build_mip_chain(mip_chain_noise(width, height)).levels)
            EXPECT_NEAR(mean(level), mean(mip_chain_noise(width, height)), 2e-7)
                << width << " " << height;
}

TEST(MipChain, ConstantsStayConstant) {
    for (const std::size_t size : {16u, 15u, 1000u})
        for (const Image<float>& level : build_mip_chain(Image<float>(size, size, 0.3f)).levels)
            for (const float value : level.pixels()) ASSERT_EQ(value, 0.3f) << size;
}

TEST(MipChain, StepBecomesTheShareOfTheTexelBehindIt) {
    constexpr std::size_t size = 32, edge = 11;  // one where x >= 11
    Image<float> step(size, size);
    for (std::size_t y = 0; y < size; ++y)
        for (std::size_t x = edge; x < size; ++x) step(x, y) = 1.0f;
    const MipChain<float> chain = build_mip_chain(step);
    for (std::size_t l = 0; l < chain.levels.size(); ++l) {
        const double texel = std::ldexp(1.0, int(l));
        for (std::size_t x = 0; x < chain.levels[l].width(); ++x) {
            const double share = std::clamp((double(x + 1) * texel - edge) / texel, 0.0, 1.0);
            EXPECT_EQ(double(chain.levels[l](x, 0)), share) << l << " " << x;
        }
    }
}

TEST(MipChain, OddSidesIntegrateTheImageOverEachTexel) {
    // Against the integral of the piecewise constant row, from its running sum.
    for (const std::size_t size : {3u, 5u, 9u, 101u}) {
        const Image<float> row = mip_chain_noise(size, 1);
        const auto integral = [&](double to) {
            double sum = 0.0;
            for (std::size_t i = 0; i < size; ++i)
                sum += double(row(i, 0)) * std::clamp(to - double(i), 0.0, 1.0);
            return sum;
        };
        const Image<float> half = halve(row);
        const double width = double(size) / double(half.width());
        for (std::size_t i = 0; i < half.width(); ++i)
            EXPECT_NEAR(double(half(i, 0)),
                        (integral(double(i + 1) * width) - integral(double(i) * width)) / width,
                        1e-6);
    }
}

TEST(MipChain, RowsInBandsGiveTheLevelOfTheWholeImage) {
    for (const auto& [width, height] : {std::pair<std::size_t, std::size_t>{8, 8},
                                        {7, 7},
                                        {5, 6},
                                        {3, 3},
                                        {2, 2},
                                        {1, 1},
                                        {9, 2},
                                        {4, 1},
                                        {33, 65}})
        for (const std::size_t band : {1u, 2u, 3u, 4u, 7u, 64u}) {
            const Image<float> image = mip_chain_noise(width, height);
            HalvedRows<float> halved(width, height);
            for (std::size_t y = 0; y < height; y += band) {
                Image<float> rows(width, std::min(band, height - y));
                std::ranges::copy(image.pixels().subspan(y * width, rows.pixels().size()),
                                  rows.row(0).begin());
                halved.add(rows);
            }
            EXPECT_EQ(halved.take(), halve(image)) << width << " x " << height << ", " << band;
        }
}

TEST(MipChain, ColoursAreThreeSeparateChannels) {
    const Image<float> red = mip_chain_noise(9, 8);
    Image<Vec3f> vectors(9, 8);
    Image<RgbF> colours(9, 8);
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 9; ++x) {
            vectors(x, y) = {red(x, y), 0.25f, float(x)};
            colours(x, y) = {red(x, y), 0.25f, float(x)};
        }
    const MipChain<float> expected = build_mip_chain(red);
    const MipChain<Vec3f> v = build_mip_chain(vectors);
    const MipChain<RgbF> c = build_mip_chain(colours);
    for (std::size_t l = 0; l < expected.levels.size(); ++l)
        for (std::size_t i = 0; i < expected.levels[l].pixels().size(); ++i) {
            EXPECT_EQ(v.levels[l].pixels()[i].x, expected.levels[l].pixels()[i]);
            EXPECT_EQ(c.levels[l].pixels()[i].r, expected.levels[l].pixels()[i]);
            EXPECT_EQ(v.levels[l].pixels()[i].y, 0.25f);
            EXPECT_EQ(c.levels[l].pixels()[i].b, v.levels[l].pixels()[i].z);
        }
    EXPECT_NEAR(double(v.levels.back().pixels()[0].z), 4.0, 1e-6);
}

}  // namespace
}  // namespace burl
