// Palettes and small files.
#include "app/image/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "app/image/image_io.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

Image<Rgb8> expanded(const IndexedImage& image) {
    Image<Rgb8> result(image.pixels.width(), image.pixels.height());
    for (std::size_t y = 0; y < result.height(); ++y)
        for (std::size_t x = 0; x < result.width(); ++x)
            result(x, y) = image.colors.at(image.pixels(x, y));
    return result;
}

/// Smooth in two directions, with `noise` codes of noise.
Image<Rgb8> gradient(std::size_t width, std::size_t height, int noise, bool grey = false) {
    std::mt19937 random(3);
    Image<Rgb8> image(width, height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const int more = int(random() % unsigned(noise + 1));
            const auto r = std::uint8_t(20 + 150 * x / width + std::size_t(more));
            const auto g = std::uint8_t(30 + 180 * y / height + std::size_t(more));
            image(x, y) = grey ? Rgb8{r, r, r} : Rgb8{r, g, std::uint8_t(255 - r)};
        }
    return image;
}

double rmse(const Image<Rgb8>& a, const Image<Rgb8>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgb8 &p = a.pixels()[i], &q = b.pixels()[i];
        for (const int d : {p.r - q.r, p.g - q.g, p.b - q.b}) sum += d * d;
    }
    return std::sqrt(sum / double(3 * a.pixels().size()));
}

TEST(Palette, FewColorsStayAsTheyAre) {
    Image<Rgb8> image(5, 3, Rgb8{1, 2, 3});
    image(2, 1) = {250, 0, 7};
    image(4, 2) = {0, 0, 0};
    const IndexedImage reduced = with_palette(image, 16);
    EXPECT_EQ(reduced.colors.size(), 3u);
    EXPECT_EQ(expanded(reduced), image);
    EXPECT_EQ(with_palette(Image<Rgb8>(1, 1, Rgb8{9, 8, 7}), 1).colors.size(), 1u);
}

TEST(Palette, OneColorIsTheMean) {
    Image<Rgb8> image(4, 1, Rgb8{10, 20, 30});
    image(0, 0) = {30, 20, 10};
    const IndexedImage reduced = with_palette(image, 1);
    ASSERT_EQ(reduced.colors.size(), 1u);
    EXPECT_EQ(reduced.colors[0], (Rgb8{15, 20, 25}));
}

TEST(Palette, MoreColorsErrLess) {
    const Image<Rgb8> image = gradient(120, 90, 20);
    double before = 1e9;
    for (const std::size_t count : {2, 8, 32, 128, 256}) {
        const IndexedImage reduced = with_palette(image, count);
        EXPECT_LE(reduced.colors.size(), count);
        const double error = rmse(expanded(reduced), image);
        EXPECT_LT(error, 0.75 * before) << count;
        before = error;
    }
    EXPECT_LT(before, 4.0);  // a 16 x 16 grid of the two gradients would err by about 4
}

TEST(Palette, PngHoldsExactlyTheIndexedPixels) {
    for (const bool grey : {false, true}) {
        const Image<Rgb8> image = gradient(61, 47, 9, grey);
        const IndexedImage reduced = with_palette(image, 100);
        EXPECT_EQ(decode_png(encode_png(reduced), "a.png"), expanded(reduced));
    }
    const Image<Rgb8> grey = gradient(40, 40, 9, true);
    EXPECT_EQ(decode_png(encode_small_png(grey, 100'000), "b.png"), grey);  // grey loses nothing
}

TEST(SmallPng, KeepsEveryColorIfItCan) {
    const Image<Rgb8> image = gradient(60, 60, 3);
    EXPECT_EQ(decode_png(encode_small_png(image, 100'000), "a.png"), image);
}

TEST(SmallPng, FitsWithFewerColorsElse) {
    const Image<Rgb8> image = gradient(110, 110, 40);
    const std::size_t whole = encode_png(image, 9).size();
    std::size_t colors = 100'000;
    for (const std::size_t limit : {whole / 2, whole / 4}) {
        const std::vector<std::uint8_t> bytes = encode_small_png(image, limit);
        EXPECT_LE(bytes.size(), limit);
        std::set<std::uint32_t> used;
        const Image<Rgb8> decoded = decode_png(bytes, "a.png");
        for (const Rgb8& p : decoded.pixels())
            used.insert(std::uint32_t(p.r) << 16 | std::uint32_t(p.g) << 8 | p.b);
        EXPECT_LT(used.size(), colors);
        colors = used.size();
    }
    EXPECT_THROW(encode_small_png(image, 100), Error);
}

}  // namespace
}  // namespace burl
