// PNG files with opacity and of numbers, read by libpng's plain interface without conversions.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "app/image/convert_image.h"
#include "app/image/image_io.h"
#include "tests/app/support/raw_png.h"

namespace burl {
namespace {

/// The linear light of a code (IEC 61966-2-1).
double decoded(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

/// All of 256 colours with all of 256 opacities, as PNG has them.
template <class Code>
Image<Rgba<Code>> all_codes() {
    constexpr std::size_t step = std::numeric_limits<Code>::max() / 255;
    Image<Rgba<Code>> image(256, 256);
    for (std::size_t y = 0; y < 256; ++y)
        for (std::size_t x = 0; x < 256; ++x) {
            // 16-bit codes that are no multiples of 257, down to 1 and up to the greatest.
            const auto code = [&](std::size_t i) {
                return Code(i * step + (step > 1 && i < 255 ? i % 7 + 1 : 0));
            };
            image(x, y) = {code(x), code(255 - x), code((x * 37 + y) % 256), code(y)};
        }
    return image;
}

template <class Code>
Image<RgbaF> multiplied(const Image<Rgba<Code>>& image) {
    const double most = std::numeric_limits<Code>::max();
    Image<RgbaF> result(image.width(), image.height());
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x) {
            const Rgba<Code>& p = image(x, y);
            const double a = p.a / most;
            result(x, y) = {float(decoded(p.r / most) * a), float(decoded(p.g / most) * a),
                            float(decoded(p.b / most) * a), float(a)};
        }
    return result;
}

template <class Code>
void expect_same(const Image<Rgba<Code>>& image, const Image<Rgba<Code>>& back) {
    for (std::size_t y = 0; y < image.height(); ++y)
        for (std::size_t x = 0; x < image.width(); ++x) {
            const Rgba<Code> expected = image(x, y).a == 0 ? Rgba<Code>{} : image(x, y);
            ASSERT_EQ(back(x, y), expected) << x << ", " << y;
        }
}

TEST(MaterialPng, EveryCodeComesBackFromPremultipliedFloats) {
    expect_same(all_codes<std::uint8_t>(), to_rgba8(multiplied(all_codes<std::uint8_t>())));
    expect_same(all_codes<std::uint16_t>(), to_rgba16(multiplied(all_codes<std::uint16_t>())));
}

TEST(MaterialPng, ColoursWithOpacityStandInTheFileAsTheyAre) {
    const auto image8 = all_codes<std::uint8_t>();
    const RawPng raw8 = raw_png(encode_png(image8));
    EXPECT_EQ(raw8.bits, 8);
    EXPECT_EQ(raw8.color_type, PNG_COLOR_TYPE_RGB_ALPHA);
    EXPECT_TRUE(raw8.srgb);
    const auto image16 = all_codes<std::uint16_t>();
    const RawPng raw16 = raw_png(encode_png(image16));
    EXPECT_EQ(raw16.bits, 16);
    EXPECT_EQ(raw16.color_type, PNG_COLOR_TYPE_RGB_ALPHA);
    ASSERT_EQ(raw8.codes.size(), 4u * 256 * 256);
    ASSERT_EQ(raw16.codes.size(), 4u * 256 * 256);
    for (std::size_t i = 0; i < 256 * 256; ++i) {
        const std::uint16_t* at8 = &raw8.codes[4 * i];
        const std::uint16_t* at16 = &raw16.codes[4 * i];
        const Rgba8& p = image8.pixels()[i];
        ASSERT_EQ((Rgba16{at8[0], at8[1], at8[2], at8[3]}), (Rgba16{p.r, p.g, p.b, p.a}));
        ASSERT_EQ((Rgba16{at16[0], at16[1], at16[2], at16[3]}), image16.pixels()[i]);
    }
    // And without opacity by the project's reader.
    const Image<Rgb8> read = decode_png(encode_png(image8), "memory");
    EXPECT_EQ(read(7, 9), (Rgb8{image8(7, 9).r, image8(7, 9).g, image8(7, 9).b}));
}

TEST(MaterialPng, NumbersAreGreyAndNotMarkedAsColours) {
    Image<float> numbers(256, 2);
    for (std::size_t x = 0; x < 256; ++x) {
        numbers(x, 0) = float(x) / 255.0f;
        numbers(x, 1) = (float(x) - 20.0f) / 200.0f;
    }
    const RawPng raw8 = raw_png(encode_png(to_grey8(numbers)));
    const RawPng raw16 = raw_png(encode_png(to_grey16(numbers)));
    EXPECT_EQ(raw8.bits, 8);
    EXPECT_EQ(raw16.bits, 16);
    for (const RawPng& raw : {raw8, raw16}) {
        EXPECT_EQ(raw.color_type, PNG_COLOR_TYPE_GRAY);
        EXPECT_FALSE(raw.srgb);
        ASSERT_EQ(raw.codes.size(), 512u);
        const double most = std::ldexp(1.0, raw.bits) - 1.0;
        for (std::size_t i = 0; i < 512; ++i) {
            const double value = std::clamp(double(numbers.pixels()[i]), 0.0, 1.0);
            EXPECT_NEAR(raw.codes[i], value * most, 0.5 + 1e-9 * most) << i;
        }
    }
    for (std::size_t x = 0; x < 256; ++x) EXPECT_EQ(raw8.codes[x], x);
}

TEST(MaterialPng, PiecesAreTheWhole) {
    const auto collected = [](const auto& image) {
        std::vector<std::uint8_t> bytes;
        encode_png(image, [&](std::span<const std::uint8_t> piece) {
            bytes.insert(bytes.end(), piece.begin(), piece.end());
        });
        return bytes;
    };
    EXPECT_EQ(collected(all_codes<std::uint8_t>()), encode_png(all_codes<std::uint8_t>()));
    EXPECT_EQ(collected(all_codes<std::uint16_t>()), encode_png(all_codes<std::uint16_t>()));
    const Image<float> number(30, 40, 0.3f);
    EXPECT_EQ(collected(to_grey8(number)), encode_png(to_grey8(number)));
    EXPECT_EQ(collected(to_grey16(number)), encode_png(to_grey16(number)));
}

TEST(MaterialPng, TransparentTexelsGetTheColourAskedFor) {
    Image<RgbaF> image(3, 1);
    image(0, 0) = {1.0f, 0.0f, 0.0f, 1.0f};
    image(1, 0) = {0.0f, 0.25f, 0.0f, 0.5f};
    const RgbF mean = mean_color(image);
    EXPECT_FLOAT_EQ(mean.r, 1.0f / 1.5f);
    EXPECT_FLOAT_EQ(mean.g, 0.25f / 1.5f);
    EXPECT_EQ(to_rgba8(image)(2, 0), (Rgba8{}));
    const Image<Rgba8> codes = to_rgba8(image, {1.0f, 0.0f, 0.0f});
    EXPECT_EQ(codes(2, 0), (Rgba8{255, 0, 0, 0}));
    EXPECT_EQ(codes(1, 0), (Rgba8{0, 188, 0, 128}));  // half of linear light is code 188
    EXPECT_EQ(mean_color(Image<RgbaF>(4, 4)), RgbF{});
}

}  // namespace
}  // namespace burl
