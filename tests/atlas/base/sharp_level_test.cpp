// Sharpened levels against closed forms: waves, ramps, what a bilinear lookup of them errs by, and
// the weights' sum texel by texel.
#include "atlas/base/sharp_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "atlas/measure/lookup.h"

namespace burl {
namespace {

/// An image of more rows than a band has, with values of 0 to 1.
Image<RgbaF> premultiplied_noise(std::size_t width, std::size_t height) {
    std::mt19937 random(11);
    const auto number = [&] { return float(random() % 4096) / 4095.0f; };
    Image<RgbaF> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (RgbaF& p : image.row(y)) {
            const float a = number();
            p = {a * number(), a * number(), a * number(), a};
        }
    return image;
}

/// The sum over the 3 x 3 texels round (x, y), from the definition.
template <class Component>
double nine(const Image<RgbaF>& image, std::size_t x, std::size_t y, const Component& component) {
    const auto weight = [](int d) { return d == 0 ? 1.0 + 2.0 * sharpness : -sharpness; };
    double sum = 0.0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
            const auto at = [](std::size_t k, int d, std::size_t size) {
                return std::size_t(std::clamp(int(k) + d, 0, int(size) - 1));
            };
            sum += weight(i) * weight(j) *
                   double(component(image(at(x, i, image.width()), at(y, j, image.height()))));
        }
    return sum;
}

TEST(SharpLevel, ConstantsAndRampsStay) {
    Image<float> image(70, 130);
    for (std::size_t y = 0; y < 130; ++y)
        for (std::size_t x = 0; x < 70; ++x)
            image(x, y) = float(0.1 + 0.005 * double(x) + 0.004 * double(y));
    const Image<float> before = image;
    sharpen(image);
    for (std::size_t y = 1; y < 129; ++y)
        for (std::size_t x = 1; x < 69; ++x) ASSERT_NEAR(image(x, y), before(x, y), 1e-7);
    Image<RgbF> grey(5, 1, RgbF{0.25f, 0.5f, 1.0f});
    sharpen(grey);
    EXPECT_EQ(grey, (Image<RgbF>(5, 1, RgbF{0.25f, 0.5f, 1.0f})));
}

TEST(SharpLevel, WavesGrowByTheirGain) {
    for (const double f : {1.0 / 32, 1.0 / 8, 0.5}) {
        Image<Vec3f> image(32, 96);
        const auto wave = [&](std::size_t x, double height) {
            return 0.5 + height * std::cos(2.0 * std::numbers::pi * f * double(x));
        };
        for (std::size_t y = 0; y < 96; ++y)
            for (std::size_t x = 0; x < 32; ++x) image(x, y) = Vec3f(float(wave(x, 0.3)));
        sharpen(image);
        const double gain = 1.0 + 2.0 * sharpness * (1.0 - std::cos(2.0 * std::numbers::pi * f));
        for (std::size_t y = 0; y < 96; ++y)
            for (std::size_t x = 1; x < 31; ++x)
                ASSERT_NEAR(image(x, y).y, wave(x, 0.3 * gain), 1e-6) << f;
    }
}

// Of a long wave's second derivative a bilinear lookup errs by t (1 - t) / 2 along an axis, 1/12 in
// the mean and 1/120^(1/2) in the root of the mean square; s takes 1/12 down to 1/12 - s.
TEST(SharpLevel, LookupsOfLongWavesErrLess) {
    const double f = 1.0 / 40.0;
    const auto mean_of = [&](double x) {  // over the texel's width round x
        return 0.5 + 0.4 * std::sin(std::numbers::pi * f) / (std::numbers::pi * f) *
                         std::cos(2.0 * std::numbers::pi * f * x);
    };
    Image<float> level(120, 3);
    for (std::size_t y = 0; y < 3; ++y)
        for (std::size_t x = 0; x < 120; ++x) level(x, y) = float(mean_of(double(x) + 0.5));
    Image<Vec3f> plain = converted<Vec3f>(level, [](float v) { return Vec3f(v); }), sharp = plain;
    sharpen(sharp);
    std::array<double, 2> squares{};
    for (double x = 2.0; x < 118.0; x += 0.0137) {
        squares[0] += std::pow(bilinear(plain, {x, 1.5}).x - mean_of(x), 2.0);
        squares[1] += std::pow(bilinear(sharp, {x, 1.5}).x - mean_of(x), 2.0);
    }
    const double mean = 1.0 / 12.0, spread = 1.0 / 120.0 - mean * mean;
    const double expected = std::sqrt((spread + std::pow(mean - sharpness, 2.0)) * 120.0);
    EXPECT_NEAR(std::sqrt(squares[1] / squares[0]), expected, 0.02);
    EXPECT_LT(expected, 0.71);
}

TEST(SharpLevel, AddsUpNineTexelsWithinLimits) {
    const Image<RgbaF> before = premultiplied_noise(37, 150);
    Image<RgbaF> image = before;
    sharpen(image);
    for (std::size_t y = 0; y < 150; ++y)
        for (std::size_t x = 0; x < 37; ++x) {
            const RgbaF& p = image(x, y);
            const auto limited = [&](float RgbaF::*component, double most) {
                const auto of = [&](const RgbaF& q) { return q.*component; };
                return std::clamp(nine(before, x, y, of), 0.0, most);
            };
            const double alpha = limited(&RgbaF::a, 1.0);
            ASSERT_NEAR(p.a, alpha, 1e-7);
            ASSERT_NEAR(p.r, limited(&RgbaF::r, alpha), 1e-7);
            ASSERT_NEAR(p.g, limited(&RgbaF::g, alpha), 1e-7);
            ASSERT_NEAR(p.b, limited(&RgbaF::b, alpha), 1e-7);
        }
}

TEST(SharpLevel, LightBeyondOneDoesNotGrow) {
    Image<float> image(3, 3, 0.0f);
    image(1, 1) = 5.0f;
    sharpen(image);
    EXPECT_EQ(image(1, 1), 5.0f);
    EXPECT_EQ(image(0, 1), 0.0f);
    Image<float> dim(3, 3, 0.0f);
    dim(1, 1) = 0.5f;
    sharpen(dim);
    EXPECT_FLOAT_EQ(dim(1, 1), float(0.5 * std::pow(1.0 + 2.0 * sharpness, 2.0)));
}

TEST(SharpLevel, IsTheSameForEveryNumberOfThreads) {
    Image<RgbaF> many = premultiplied_noise(64, 1000), one = many;
    sharpen(many);
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    sharpen(one);
    EXPECT_EQ(many, one);
}

}  // namespace
}  // namespace burl
