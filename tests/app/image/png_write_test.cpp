// PNG files of several bands, read by libpng's plain interface.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <zlib.h>

#include "app/image/image_io.h"
#include "tests/app/support/raw_png.h"

namespace burl {
namespace {

/// Waves and noise, by turns, so that bands choose different filters.
template <class Pixel>
Image<Pixel> banded_picture(std::size_t width, std::size_t height) {
    Image<Pixel> image(width, height);
    std::uint32_t state = 1;
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            std::uint64_t codes = 0;
            for (std::size_t k = 0; k < sizeof(Pixel); ++k) {
                state = state * 1664525u + 1013904223u;
                const double wave = std::sin(double(x) * 0.02 + double(k + y / 100 * y) * 0.01);
                const std::uint32_t noise = y / 200 % 2 == 0 ? state >> 30 : state >> 24;
                codes = codes << 8 | ((std::uint32_t(100.0 + 90.0 * wave) + noise) & 255u);
            }
            std::memcpy(static_cast<void*>(&image(x, y)), &codes, sizeof(Pixel));
        }
    return image;
}

template <class Pixel>
std::vector<std::uint16_t> codes_in(const Image<Pixel>& image) {
    using Code = std::conditional_t<sizeof(Pixel) % 6 == 0 || sizeof(Pixel) % 8 == 0 ||
                                        std::is_same_v<Pixel, Grey16>,
                                    std::uint16_t, std::uint8_t>;
    const auto* codes = reinterpret_cast<const Code*>(image.pixels().data());
    return {codes, codes + image.pixels().size() * sizeof(Pixel) / sizeof(Code)};
}

template <class Pixel>
void expect_codes(std::size_t width, std::size_t height, int color_type) {
    const Image<Pixel> image = banded_picture<Pixel>(width, height);
    for (const int level : {png_level, 0, 9}) {
        const RawPng raw = raw_png(encode_png(image, level));
        EXPECT_EQ(raw.width, width);
        EXPECT_EQ(raw.height, height);
        EXPECT_EQ(raw.color_type, color_type);
        EXPECT_EQ(raw.codes, codes_in(image)) << width << " x " << height;
    }
}

TEST(PngWrite, BandsHoldEveryCode) {
    expect_codes<Rgb8>(601, 1200, PNG_COLOR_TYPE_RGB);  // five bands
    expect_codes<Rgba8>(333, 801, PNG_COLOR_TYPE_RGB_ALPHA);
    expect_codes<Rgb16>(257, 900, PNG_COLOR_TYPE_RGB);
    expect_codes<Rgba16>(100, 1500, PNG_COLOR_TYPE_RGB_ALPHA);
    expect_codes<Grey8>(1001, 1111, PNG_COLOR_TYPE_GRAY);
    expect_codes<Grey16>(999, 555, PNG_COLOR_TYPE_GRAY);
    expect_codes<Rgb8>(1, 5, PNG_COLOR_TYPE_RGB);
    expect_codes<Rgb8>(300000, 3, PNG_COLOR_TYPE_RGB);  // rows that are longer than a band
}

TEST(PngWrite, BytesAreTheSameForEveryNumberOfThreads) {
    const Image<Rgb8> image = banded_picture<Rgb8>(700, 2000);
    std::vector<std::vector<std::uint8_t>> files;
    for (const std::size_t threads : {1, 2, 5}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        files.push_back(encode_png(image));
    }
    EXPECT_EQ(files[0], files[1]);
    EXPECT_EQ(files[0], files[2]);
}

/// The filters of a picture's rows: the first byte of each.
std::vector<int> filters_in(const Image<Rgb8>& image) {
    const std::vector<std::uint8_t> file = encode_png(image);
    std::vector<std::uint8_t> compressed;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t length = std::size_t(file[at]) << 24 | std::size_t(file[at + 1]) << 16 |
                                   file[at + 2] << 8 | file[at + 3];
        if (std::memcmp(&file[at + 4], "IDAT", 4) == 0)
            compressed.insert(compressed.end(), file.begin() + std::ptrdiff_t(at + 8),
                              file.begin() + std::ptrdiff_t(at + 8 + length));
        at += length + 12;
    }
    const std::size_t stride = 1 + 3 * image.width();
    std::vector<std::uint8_t> rows(stride * image.height());
    auto size = uLongf(rows.size());
    EXPECT_EQ(::uncompress(rows.data(), &size, compressed.data(), uLong(compressed.size())), Z_OK);
    std::vector<int> filters;
    for (std::size_t y = 0; y < image.height(); ++y) filters.push_back(rows[y * stride]);
    return filters;
}

/// A picture whose codes are predicted by `predict(left, up)`, but for the lowest two bits.
template <class Predict>
Image<Rgb8> predicted_picture(const Predict& predict) {
    Image<Rgb8> image(256, 256);
    std::uint32_t state = 1;
    for (std::size_t y = 0; y < 256; ++y)
        for (std::size_t x = 0; x < 256; ++x)
            for (std::uint8_t Rgb8::*channel : {&Rgb8::r, &Rgb8::g, &Rgb8::b}) {
                state = state * 1664525u + 1013904223u;
                const int left = x > 0 ? image(x - 1, y).*channel : 0;
                const int up = y > 0 ? image(x, y - 1).*channel : 0;
                image(x, y).*channel = std::uint8_t(unsigned(predict(left, up)) + (state >> 30));
            }
    return image;
}

TEST(PngWrite, RowsHaveTheFilterThatPredictsThemBest) {
    const auto all = [](int filter) { return std::vector<int>(256, filter); };
    EXPECT_EQ(filters_in(predicted_picture([](int left, int) { return left; })), all(1));
    EXPECT_EQ(filters_in(predicted_picture([](int, int up) { return up; })), all(2));
    EXPECT_EQ(filters_in(predicted_picture([](int left, int up) { return (left + up) / 2; })),
              all(3));
    EXPECT_EQ(filters_in(Image<Rgb8>(256, 256)).size(), 256u);
}

// libpng compresses by zlib's level 6, which takes three times as long.
TEST(PngWrite, IsHardlyLargerThanLibpngsOwnFiles) {
    const Image<Rgb8> image = banded_picture<Rgb8>(1024, 1024);
    png_image raw{};
    raw.version = PNG_IMAGE_VERSION;
    raw.width = raw.height = 1024;
    raw.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    ASSERT_TRUE(
        png_image_write_to_memory(&raw, nullptr, &size, 0, image.pixels().data(), 0, nullptr));
    const std::size_t ours = encode_png(image).size();
    EXPECT_LT(double(ours), 1.01 * double(size));
    EXPECT_GT(ours, size / 4) << "noise cannot be";
}

}  // namespace
}  // namespace burl
