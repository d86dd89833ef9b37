// Pictures in JPEG, WebP and KTX2, read by their libraries and, of KTX2, by the specification.
#include "app/image/picture_coding.h"

#include <cmath>
#include <cstdio>
#include <cstring>

#include <gtest/gtest.h>
#include <jpeglib.h>
#include <webp/decode.h>
#include <zstd.h>

#include "atlas/base/error.h"

namespace burl {
namespace {

template <class Encode>
std::vector<std::uint8_t> bytes_of_file(const Encode& encode) {
    std::vector<std::uint8_t> bytes;
    encode([&](std::span<const std::uint8_t> piece) {
        bytes.insert(bytes.end(), piece.begin(), piece.end());
    });
    return bytes;
}

template <class Pixel>
std::vector<std::uint8_t> coded_file(const Image<Pixel>& image, const std::string& coding,
                                     PngContent content = png_content<Pixel>) {
    return bytes_of_file(
        [&](const ByteSink& sink) { encode_picture(image, sink, coding_named(coding), content); });
}

/// Smooth colours, with a little noise in the last bits.
template <class Pixel>
Image<Pixel> smooth_picture(std::size_t width, std::size_t height) {
    Image<Pixel> image(width, height);
    std::uint32_t state = 7;
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            std::uint8_t codes[sizeof(Pixel)];
            for (std::size_t c = 0; c < sizeof(Pixel); ++c) {
                state = state * 1664525u + 1013904223u;
                const double wave =
                    std::sin(double(x) * 0.11 + double(c)) * std::cos(0.07 * double(y));
                codes[c] = std::uint8_t(120.0 + 100.0 * wave + double(state >> 30));
            }
            std::memcpy(static_cast<void*>(&image(x, y)), codes, sizeof(Pixel));
        }
    return image;
}

double rms(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b) {
    EXPECT_EQ(a.size(), b.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        sum += std::pow(double(a[i]) - double(b[i]), 2);
    return std::sqrt(sum / double(a.size()));
}

template <class Pixel>
std::span<const std::uint8_t> raw_codes(const Image<Pixel>& image) {
    return {reinterpret_cast<const std::uint8_t*>(image.pixels().data()),
            image.pixels().size() * sizeof(Pixel)};
}

/// A JPEG by libjpeg's plain interface, whose own error handler ends the test program.
struct RawJpeg {
    std::size_t width = 0, height = 0;
    int components = 0;
    bool is_subsampled = false;
    std::vector<std::uint8_t> codes{};
};

RawJpeg raw_jpeg(const std::vector<std::uint8_t>& bytes) {
    ::jpeg_decompress_struct jpeg;
    ::jpeg_error_mgr errors;
    jpeg.err = ::jpeg_std_error(&errors);
    ::jpeg_create_decompress(&jpeg);
    ::jpeg_mem_src(&jpeg, bytes.data(), bytes.size());
    ::picture_read.header(&jpeg, TRUE);
    ::jpeg_start_decompress(&jpeg);
    RawJpeg raw{jpeg.output_width, jpeg.output_height, jpeg.output_components, false, {}};
    for (int c = 0; c < jpeg.num_components; ++c)
        raw.is_subsampled |= jpeg.comp_info[c].h_samp_factor != jpeg.max_h_samp_factor;
    const std::size_t stride = raw.width * std::size_t(raw.components);
    raw.codes.resize(stride * raw.height);
    while (jpeg.output_scanline < jpeg.output_height) {
        ::JSAMPROW row = &raw.codes[jpeg.output_scanline * stride];
        ::jpeg_read_scanlines(&jpeg, &row, 1);
    }
    ::jpeg_destroy_decompress(&jpeg);
    return raw;
}

TEST(PictureCoding, WordsAndQualities) {
    EXPECT_EQ(coding_named("png").format, TextureFormat::png);
    EXPECT_EQ(coding_named("jpeg:85").quality, 85);
    EXPECT_EQ(coding_named("webp").quality, std::nullopt);
    EXPECT_EQ(coding_named("ktx2:0").quality, 0);
    for (const std::string wrong : {"", "gif", "PNG", "png:9", "jpeg:", "jpeg:0", "jpeg:101",
                                    "webp:-1", "webp:9x", "ktx2:20", "jpeg:90:90", ":5"}) {
        try {
            coding_named(wrong);
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            EXPECT_NE(std::string(error.what()).find("--picture-format"), std::string::npos);
        }
    }
    EXPECT_EQ(texture_format_of("a/b.JPEG"), TextureFormat::jpeg);
    EXPECT_EQ(texture_format_of("b.jpg"), TextureFormat::jpeg);
    EXPECT_EQ(texture_format_of("b.ktx2"), TextureFormat::ktx2);
    EXPECT_EQ(texture_format_of("b.exr"), std::nullopt);
}

TEST(PictureCoding, JpegIsCloseAndNotSubsampled) {
    const Image<Rgb8> image = smooth_picture<Rgb8>(203, 101);
    double before = 1e9;
    for (const int quality : {30, 90, 100}) {
        const RawJpeg raw = raw_jpeg(coded_file(image, fmt::format("jpeg:{}", quality)));
        EXPECT_EQ(raw.width, 203u);
        EXPECT_EQ(raw.height, 101u);
        EXPECT_EQ(raw.components, 3);
        EXPECT_FALSE(raw.is_subsampled);
        const double error = rms(raw.codes, raw_codes(image));
        EXPECT_LT(error, before) << quality;
        before = error;
    }
    EXPECT_LT(before, 1.0);
}

TEST(PictureCoding, JpegOfNumbersIsGreyAndOfHighQuality) {
    const Image<Grey8> image = smooth_picture<Grey8>(64, 80);
    const RawJpeg raw = raw_jpeg(coded_file(image, "jpeg:5"));
    EXPECT_EQ(raw.components, 1);
    EXPECT_LT(rms(raw.codes, raw_codes(image)), 2.0);
    const Image<Rgb8> normals = smooth_picture<Rgb8>(64, 80);
    EXPECT_EQ(coded_file(normals, "jpeg:5", PngContent::data),
              coded_file(normals, "jpeg:95", PngContent::color));
}

TEST(PictureCoding, WebpKeepsEveryCodeUnlessToldOtherwise) {
    int width = 0, height = 0;
    const Image<Rgba8> image = smooth_picture<Rgba8>(97, 45);  // also where alpha is 0
    const auto decoded = [&](const std::vector<std::uint8_t>& bytes, std::size_t count) {
        std::uint8_t* codes = ::WebPDecodeRGBA(bytes.data(), bytes.size(), &width, &height);
        EXPECT_NE(codes, nullptr);
        const std::vector<std::uint8_t> all(codes, codes + count);
        ::WebPFree(codes);
        return all;
    };
    const std::size_t count = 97 * 45 * 4;
    const std::vector<std::uint8_t> lossless = coded_file(image, "webp");
    EXPECT_EQ(rms(decoded(lossless, count), raw_codes(image)), 0.0);
    EXPECT_EQ(width, 97);
    EXPECT_EQ(height, 45);
    EXPECT_EQ(coded_file(image, "webp:100"), lossless);
    EXPECT_EQ(coded_file(image, "webp:40", PngContent::data), lossless) << "data lose nothing";
    const std::vector<std::uint8_t> lossy = coded_file(image, "webp:80");
    EXPECT_LT(lossy.size(), lossless.size() / 2);
    const double error = rms(decoded(lossy, count), raw_codes(image));
    EXPECT_GT(error, 0.1);
    EXPECT_LT(error, 8.0);
    const std::vector<std::uint8_t> grey =
        decoded(coded_file(smooth_picture<Grey8>(97, 45), "webp"), count);
    for (std::size_t i = 0; i < grey.size(); i += 4) {
        ASSERT_EQ(grey[i], raw_codes(smooth_picture<Grey8>(97, 45))[i / 4]);
        ASSERT_EQ(grey[i], grey[i + 1]);
    }
}

/// Little-endian numbers of a KTX2 file.
std::uint64_t number_in(const std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t size) {
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < size; ++k) number |= std::uint64_t(bytes.at(at + k)) << (8 * k);
    return number;
}

/// The texels of a level, by section 3 of the specification.
std::vector<std::uint8_t> ktx_level(const std::vector<std::uint8_t>& file, std::size_t level) {
    const std::size_t entry = 80 + 24 * level;
    const std::size_t begin = number_in(file, entry, 8), size = number_in(file, entry + 8, 8),
                      unpacked = number_in(file, entry + 16, 8);
    EXPECT_LE(begin + size, file.size());
    if (number_in(file, 44, 4) == 0) {
        EXPECT_EQ(size, unpacked);
        EXPECT_EQ(begin % 4, 0u);
        return {file.begin() + std::ptrdiff_t(begin), file.begin() + std::ptrdiff_t(begin + size)};
    }
    std::vector<std::uint8_t> out(unpacked);
    EXPECT_EQ(::ZSTD_decompress(out.data(), unpacked, &file[begin], size), unpacked);
    return out;
}

TEST(PictureCoding, Ktx2HoldsLevelsAsTheyAre) {
    const std::vector<Image<Rgb8>> levels{smooth_picture<Rgb8>(13, 6), smooth_picture<Rgb8>(6, 3),
                                          smooth_picture<Rgb8>(3, 1), smooth_picture<Rgb8>(1, 1)};
    std::vector<CodeRaster> rasters;
    for (const Image<Rgb8>& level : levels) rasters.push_back(codes_of(level));
    for (const int zstd : {0, 3}) {
        const auto file = bytes_of_file(
            [&](const ByteSink& sink) { encode_ktx2(rasters, sink, zstd, PngContent::color); });
        EXPECT_EQ(std::string(file.begin() + 1, file.begin() + 7), "KTX 20");
        EXPECT_EQ(number_in(file, 12, 4), 43u) << "VK_FORMAT_R8G8B8A8_SRGB";
        EXPECT_EQ(number_in(file, 20, 4), 13u);
        EXPECT_EQ(number_in(file, 24, 4), 6u);
        EXPECT_EQ(number_in(file, 36, 4), 1u) << "faces";
        EXPECT_EQ(number_in(file, 40, 4), 4u) << "levels";
        EXPECT_EQ(number_in(file, 44, 4), zstd > 0 ? 2u : 0u);
        const std::size_t about = number_in(file, 48, 4);
        EXPECT_EQ(number_in(file, about, 4), number_in(file, 52, 4));
        EXPECT_EQ(number_in(file, about + 10, 2), 24u + 4 * 16u);
        EXPECT_EQ(number_in(file, about + 14, 1), 2u) << "sRGB";
        EXPECT_EQ(number_in(file, about + 20, 1), zstd > 0 ? 0u : 4u) << "bytes of a texel";
        EXPECT_EQ(number_in(file, about + 28 + 3 * 16 + 3, 1), 15u | 16u) << "linear alpha";
        const std::size_t keys = number_in(file, 56, 4);
        EXPECT_EQ(std::string(file.begin() + std::ptrdiff_t(keys) + 4,
                              file.begin() + std::ptrdiff_t(keys) + 21),
                  std::string("KTXorientation\0rd", 17));
        for (std::size_t l = 0; l < levels.size(); ++l) {
            const std::vector<std::uint8_t> texels = ktx_level(file, l);
            ASSERT_EQ(texels.size(), levels[l].pixels().size() * 4);
            for (std::size_t i = 0; i < levels[l].pixels().size(); ++i) {
                const Rgb8& p = levels[l].pixels()[i];
                ASSERT_EQ(
                    (Rgba8{texels[4 * i], texels[4 * i + 1], texels[4 * i + 2], texels[4 * i + 3]}),
                    (Rgba8{p.r, p.g, p.b, 255}));
            }
        }
    }
}

TEST(PictureCoding, Ktx2OfDataIsNotSrgb) {
    const Image<Grey8> grey = smooth_picture<Grey8>(5, 7);
    const std::vector<std::uint8_t> file = coded_file(grey, "ktx2");
    EXPECT_EQ(number_in(file, 12, 4), 9u) << "VK_FORMAT_R8_UNORM";
    EXPECT_EQ(rms(ktx_level(file, 0), raw_codes(grey)), 0.0);
    const Image<Rgba8> mask = smooth_picture<Rgba8>(5, 7);
    const std::vector<std::uint8_t> data = coded_file(mask, "ktx2", PngContent::data);
    EXPECT_EQ(number_in(data, 12, 4), 37u) << "VK_FORMAT_R8G8B8A8_UNORM";
    EXPECT_EQ(number_in(data, number_in(data, 48, 4) + 14, 1), 1u) << "linear";
    EXPECT_EQ(rms(ktx_level(data, 0), raw_codes(mask)), 0.0);
}

TEST(PictureCoding, WhatAFormatHasNotIsRefused) {
    const auto refused = [](const auto& image, const std::string& coding, const char* what) {
        try {
            coded_file(image, coding);
            ADD_FAILURE() << coding;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::unsupported);
            EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
        }
    };
    refused(Image<Rgba8>(2, 2), "jpeg", "alpha");
    for (const char* coding : {"jpeg", "webp", "ktx2"}) {
        refused(Image<Rgb16>(2, 2), coding, "16 bits");
        refused(Image<Grey16>(2, 2), coding, "16 bits");
    }
    refused(Image<Grey8>(20000, 1), "webp", "16383");
    refused(Image<Grey8>(1, 70000), "jpeg", "65500");
}

TEST(PictureCoding, WhatTheSinkThrowsComesOut) {
    const Image<Rgb8> image = smooth_picture<Rgb8>(300, 300);
    for (const char* coding : {"png", "jpeg", "webp", "webp:50", "ktx2", "ktx2:0"}) {
        std::size_t calls = 0;
        const auto full = [&](std::span<const std::uint8_t>) {
            ++calls;
            throw Error(ExitCode::io, "the disk is full");
        };
        try {
            encode_picture(image, full, coding_named(coding));
            ADD_FAILURE() << coding;
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), "the disk is full") << coding;
        }
        EXPECT_EQ(calls, 1u) << coding;
    }
}

}  // namespace
}  // namespace burl
