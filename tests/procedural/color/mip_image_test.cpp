#include "procedural/color/mip_image.h"

#include <array>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "procedural/color/srgb.h"

namespace burl {
namespace {

Image<Rgb8> random_image(std::size_t width, std::size_t height, std::uint32_t seed) {
    std::mt19937 random(seed);
    Image<Rgb8> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            image(x, y) = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random())};
    return image;
}

Vec3d linear(const Rgb8& c) {
    return {srgb_decode(c.r / 255.0), srgb_decode(c.g / 255.0), srgb_decode(c.b / 255.0)};
}

double mip_image_distance(const Vec3d& a, const Vec3d& b) {
    return glm::length(a - b);
}

void expect_same_texels(const MipImage& a, const MipImage& b) {
    ASSERT_EQ(a.level_count(), b.level_count());
    for (std::size_t level = 0; level < a.level_count(); ++level)
        for (std::size_t y = 0; y < a.height(level); ++y)
            for (std::size_t x = 0; x < a.width(level); ++x)
                EXPECT_EQ(a.texel(level, x, y), b.texel(level, x, y)) << level << " " << x;
}

TEST(MipImage, LevelsAreMeans) {
    const Image<Rgb8> source = random_image(16, 4, 1);
    const MipImage image(source, ImageWrap::repeat);
    ASSERT_EQ(image.level_count(), 5u);
    EXPECT_EQ(image.width(1), 8u);
    EXPECT_EQ(image.height(1), 2u);
    EXPECT_EQ(image.width(3), 2u);
    EXPECT_EQ(image.height(3), 1u);
    Vec3d mean(0.0);
    for (const Rgb8& c : source.pixels()) mean += linear(c) / 64.0;
    const RgbF top = image.texel(4, 0, 0);
    EXPECT_LT(mip_image_distance(Vec3d(top.r, top.g, top.b), mean), 1e-6);
}

TEST(MipImage, OtherSidesAreResampled) {
    // A constant stays one; a smooth wave keeps its values, within what four points can do.
    const MipImage flat(Image<Rgb8>(5, 3, {200, 100, 50}), ImageWrap::clamp);
    EXPECT_EQ(flat.width(0), 8u);
    EXPECT_EQ(flat.height(0), 4u);
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 8; ++x) {
            const RgbF c = flat.texel(0, x, y);
            EXPECT_LT(mip_image_distance({c.r, c.g, c.b}, linear({200, 100, 50})), 1e-6);
        }
    Image<Rgb8> wave(48, 1);
    for (std::size_t x = 0; x < 48; ++x) {
        const double value = 0.5 + 0.4 * std::sin(2 * 3.14159265358979 * (double(x) + 0.5) / 48);
        wave(x, 0).r = std::uint8_t(std::lround(255.0 * srgb_encode(value)));
    }
    const MipImage resampled(wave, ImageWrap::repeat);
    ASSERT_EQ(resampled.width(0), 64u);
    for (std::size_t x = 0; x < 64; ++x) {
        const double value = 0.5 + 0.4 * std::sin(2 * 3.14159265358979 * (double(x) + 0.5) / 64);
        EXPECT_NEAR(double(resampled.texel(0, x, 0).r), value, 0.012) << x;
    }
}

TEST(MipImage, TexelsResampledWhenTheyAreLookedUpAreThoseKept) {
    Image<Rgba8> torn(13, 7);
    std::mt19937 random(4);
    for (std::size_t y = 0; y < 7; ++y)
        for (Rgba8& c : torn.row(y))
            c = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random()),
                 std::uint8_t(random() % 3 * 127)};
    for (const ImageWrap wrap : {ImageWrap::repeat, ImageWrap::black, ImageWrap::clamp}) {
        for (const auto& [width, height] : {std::pair{13u, 7u}, {16u, 5u}, {5u, 16u}}) {
            const Image<Rgb8> opaque = random_image(width, height, 5);
            expect_same_texels(MipImage(opaque, wrap), MipImage(opaque, wrap, 0));
        }
        const MipImage kept(torn, wrap), looked_up(torn, wrap, 0);
        expect_same_texels(kept, looked_up);
        expect_same_texels(*kept.alpha(), *looked_up.alpha());
    }
}

TEST(MipImage, ManyThreadsMayNeedTheLevelsFirst) {
    const MipImage image(random_image(200, 100, 6), ImageWrap::repeat);
    std::array<RgbF, 8> tops{};
    std::vector<std::jthread> threads;
    for (RgbF& top : tops) threads.emplace_back([&] { top = image.texel(8, 0, 0); });
    threads.clear();
    EXPECT_GT(tops[0].r, 0.1f);
    for (const RgbF& top : tops) EXPECT_EQ(top, tops[0]);
}

TEST(MipImage, TexelCentresAreExactAndWrapsDiffer) {
    const Image<Rgb8> source = random_image(4, 4, 2);
    const MipImage repeat(source, ImageWrap::repeat), black(source, ImageWrap::black),
        clamp(source, ImageWrap::clamp);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const double s = (i + 0.5) / 4, t = (j + 0.5) / 4;
            const Vec3d color = linear(source(std::size_t(i), std::size_t(j)));
            EXPECT_LT(mip_image_distance(repeat.bilinear(0, s, t).color, color), 1e-7);
            EXPECT_LT(mip_image_distance(repeat.bilinear(0, s - 3, t + 2).color, color), 1e-7);
            EXPECT_LT(mip_image_distance(clamp.bilinear(0, s, t).color, color), 1e-7);
        }
    EXPECT_EQ(black.bilinear(0, -1.5, 0.5).color, Vec3d(0.0));
    EXPECT_LT(mip_image_distance(clamp.bilinear(0, -7, 0.125).color, linear(source(0, 0))), 1e-7);
    EXPECT_LT(mip_image_distance(clamp.bilinear(0, 9, 11).color, linear(source(3, 3))), 1e-7);
    EXPECT_LT(mip_image_distance(black.bilinear(0, 0.0, 0.125).color, 0.5 * linear(source(0, 0))),
              1e-7);
}

TEST(MipImage, LevelsFollowTheWidth) {
    const MipImage image(random_image(16, 16, 3), ImageWrap::repeat);
    const double s = 0.31, t = 0.77;
    EXPECT_EQ(image.trilinear(s, t, 0.0).color, image.bilinear(0, s, t).color);
    EXPECT_EQ(image.trilinear(s, t, 1.0 / 16).color, image.bilinear(0, s, t).color);
    EXPECT_EQ(image.trilinear(s, t, 1.0 / 8).color, image.bilinear(1, s, t).color);
    EXPECT_EQ(image.trilinear(s, t, 1.0 / 4).color, image.bilinear(2, s, t).color);
    EXPECT_EQ(image.trilinear(s, t, 1e9).color, image.bilinear(4, s, t).color);
    const Vec3d between = 0.5 * (image.bilinear(1, s, t).color + image.bilinear(2, s, t).color);
    EXPECT_LT(mip_image_distance(image.trilinear(s, t, std::sqrt(2.0) / 8).color, between), 1e-12);
}

TEST(MipImage, EllipsesAverageAlongTheFootprintOnly) {
    // Bars along t: a footprint along t leaves them, one along s takes their mean.
    Image<Rgb8> bars(64, 64);
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x)
            if (x / 4 % 2 == 0) bars(x, y) = {255, 255, 255};
    const MipImage image(bars, ImageWrap::repeat);
    const double s = 2.0 / 64, t = 0.5, fine = 1.0 / 64, broad = 8.0 / 64;
    EXPECT_NEAR(image.ewa(s, t, {fine, 0}, {0, broad}, 8).color.x, 1.0, 0.02);
    EXPECT_NEAR(image.ewa(s, t, {broad, 0}, {0, fine}, 8).color.x, 0.5, 0.06);
    // Trilinear can only take the whole square.
    EXPECT_NEAR(image.trilinear(s, t, 2 * broad).color.x, 0.5, 0.01);
    // Turned round or with its axes exchanged, it is the same ellipse.
    EXPECT_NEAR(image.ewa(s, t, {0, broad}, {-fine, 0}, 8).color.x,
                image.ewa(s, t, {fine, 0}, {0, broad}, 8).color.x, 1e-12);
    EXPECT_EQ(image.ewa(s, t, {0, 0}, {0, 0}, 8).color, image.bilinear(0, s, t).color);
}

TEST(MipImage, ConstantsStayConstant) {
    const MipImage image(Image<Rgb8>(8, 8, {10, 200, 90}), ImageWrap::repeat);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-3.0, 3.0);
    for (int k = 0; k < 200; ++k) {
        const double s = unit(random), t = unit(random);
        const Vec2d u{unit(random), 0.1 * unit(random)}, v{0.01 * unit(random), unit(random)};
        for (const double scale : {1e-12, 0.01, 0.3, 1e6}) {
            const ImageSample sample = image.ewa(s, t, scale * u, scale * v, 8);
            EXPECT_LT(mip_image_distance(sample.color, linear({10, 200, 90})), 1e-6);
            EXPECT_LT(glm::length(sample.by_s) + glm::length(sample.by_t), 1e-5);
        }
    }
}

TEST(MipImage, DerivativesAgreeWithDifferences) {
    const MipImage image(random_image(32, 16, 7), ImageWrap::repeat);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    constexpr double h = 1e-6;
    int checked = 0;
    for (int k = 0; k < 200; ++k) {
        const double s = unit(random), t = unit(random);
        const auto check = [&](const auto& lookup) {
            const ImageSample sample = lookup(s, t);
            const Vec3d by_s = (lookup(s + h, t).color - lookup(s - h, t).color) / (2 * h);
            const Vec3d by_t = (lookup(s, t + h).color - lookup(s, t - h).color) / (2 * h);
            // Not across a line of texels, where the bilinear slope jumps.
            const Vec3d near = (lookup(s + 2 * h, t).color - lookup(s - 2 * h, t).color) / (4 * h);
            if (mip_image_distance(by_s, near) > 1e-6) return;
            ++checked;
            EXPECT_LT(mip_image_distance(sample.by_s, by_s), 1e-5 * (1 + glm::length(by_s)));
            EXPECT_LT(mip_image_distance(sample.by_t, by_t), 1e-4 * (1 + glm::length(by_t)));
        };
        check([&](double x, double y) { return image.trilinear(x, y, 0.15); });
        check([&](double x, double y) { return image.ewa(x, y, {0.2, 0.05}, {-0.02, 0.1}, 8); });
    }
    EXPECT_GT(checked, 350);
}

TEST(MipImage, FarAwayIsFinite) {
    const MipImage image(random_image(8, 8, 11), ImageWrap::repeat);
    for (const double far : {1e20, -1e300, std::nan("")}) {
        EXPECT_TRUE(std::isfinite(image.trilinear(far, 0.5, 0.1).color.x));
        EXPECT_TRUE(std::isfinite(image.ewa(0.5, far, {0.1, 0}, {0, 0.2}, 8).color.x));
        EXPECT_TRUE(std::isfinite(image.ewa(0.5, 0.5, {far, 0}, {0, 0.2}, 8).color.x));
    }
}

}  // namespace
}  // namespace burl
