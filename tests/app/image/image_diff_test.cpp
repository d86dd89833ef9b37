#include "app/image/image_diff.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "atlas/base/error.h"

namespace burl {
namespace {

TEST(ImageDiff, IdenticalPicturesAreInfinitelyClose) {
    const Image<Rgb8> a(5, 3, {1, 2, 3});
    const ImageDiff diff = diff_images(a, a);
    EXPECT_EQ(diff.psnr_db, std::numeric_limits<double>::infinity());
    EXPECT_EQ(diff.maximum, 0.0);
    EXPECT_EQ(diff.rmse, 0.0);
    EXPECT_EQ(diff.pixels, 15u);
    EXPECT_EQ(diff.above_tolerance, 0u);
    EXPECT_TRUE(diff.within(0.0));
    EXPECT_EQ(diff.false_color, Image<Rgb8>(5, 3, {0, 0, 0}));
}

TEST(ImageDiff, ConstantDifferenceInClosedForm) {
    const Image<Rgb8> a(4, 4, {100, 100, 100}), b(4, 4, {151, 151, 151});  // 51 / 255 = 1/5
    const ImageDiff diff = diff_images(a, b);
    EXPECT_DOUBLE_EQ(diff.maximum, 0.2);
    EXPECT_DOUBLE_EQ(diff.rmse, 0.2);
    EXPECT_NEAR(diff.psnr_db, 20.0 * std::log10(5.0), 1e-12);
}

TEST(ImageDiff, OneChannelOfOnePixel) {
    Image<Rgb8> a(10, 10, {9, 9, 9}), b = a;
    b(3, 7).g = 9 + 51;
    const ImageDiff diff = diff_images(a, b, {.tolerance = 0.1, .scale = 0.2});
    EXPECT_DOUBLE_EQ(diff.maximum, 0.2);
    EXPECT_NEAR(diff.rmse, 0.2 / std::sqrt(300.0), 1e-15);
    EXPECT_NEAR(diff.psnr_db, 20.0 * std::log10(5.0) + 10.0 * std::log10(300.0), 1e-12);
    EXPECT_EQ(diff.above_tolerance, 1u);
    EXPECT_FALSE(diff.within(0.1));
    EXPECT_TRUE(diff.within(0.2));
    EXPECT_EQ(diff.false_color(3, 7), (Rgb8{255, 255, 255}));
    EXPECT_EQ(diff.false_color(7, 3), (Rgb8{0, 0, 0}));
    EXPECT_EQ(diff_images(a, b, {.tolerance = 0.2}).above_tolerance, 0u);
}

TEST(ImageDiff, IsSymmetric) {
    Image<Rgb8> a(2, 1), b(2, 1);
    a(0, 0) = {255, 0, 7};
    b(1, 0) = {3, 200, 0};
    EXPECT_EQ(diff_images(a, b).rmse, diff_images(b, a).rmse);
    EXPECT_EQ(diff_images(a, b).false_color, diff_images(b, a).false_color);
}

TEST(ImageDiff, IgnoredColorLeavesPixelsOut) {
    const Rgb8 background{176, 176, 176};
    Image<Rgb8> a(4, 1, background), b(4, 1, background);
    a(0, 0) = {0, 0, 0};  // only in a: left out
    b(1, 0) = {0, 0, 0};  // only in b: left out
    a(2, 0) = {10, 10, 10};
    b(2, 0) = {61, 61, 61};
    const ImageDiff diff = diff_images(a, b, {.ignore = background});
    EXPECT_EQ(diff.pixels, 1u);
    EXPECT_EQ(diff.ignored, 3u);
    EXPECT_DOUBLE_EQ(diff.maximum, 0.2);
    EXPECT_DOUBLE_EQ(diff.rmse, 0.2);
}

TEST(ImageDiff, RefusesDifferentSizes) {
    try {
        diff_images(Image<Rgb8>(4, 5), Image<Rgb8>(5, 4));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::invalid_file);
        EXPECT_NE(std::string(error.what()).find("4x5"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("5x4"), std::string::npos);
    }
}

TEST(FalseColor, BrightensWithTheDifference) {
    double last = -1.0;
    for (int i = 0; i <= 64; ++i) {
        const Rgb8 c = false_color(i / 64.0);
        const double luma = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        EXPECT_GT(luma, last);
        last = luma;
    }
    EXPECT_EQ(false_color(7.0), (Rgb8{255, 255, 255}));
}

}  // namespace
}  // namespace burl
