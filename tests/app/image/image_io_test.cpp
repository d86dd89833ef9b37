// PNG out and in: every pixel survives, foreign kinds of PNG come in as RGB, damage is refused.
#include "app/image/image_io.h"

#include <algorithm>

#include <png.h>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "atlas/base/error.h"
#include "tests/app/support/scratch_folder.h"

namespace burl {
namespace {

Image<Rgb8> pattern8(std::size_t width, std::size_t height) {
    Image<Rgb8> image(width, height);
    std::uint32_t state = 1;
    for (std::size_t y = 0; y < height; ++y) {
        for (Rgb8& p : image.row(y)) {
            state = state * 1664525u + 1013904223u;
            p = {std::uint8_t(state >> 24), std::uint8_t(state >> 16), std::uint8_t(y)};
        }
    }
    return image;
}

std::uint32_t big_endian(const std::vector<std::uint8_t>& b, std::size_t at) {
    return std::uint32_t(b[at] << 24 | b[at + 1] << 16 | b[at + 2] << 8 | b[at + 3]);
}

/// A PNG of any libpng format by the simplified interface: an encoder path of its own.
std::vector<std::uint8_t> foreign_png(png_uint_32 format, std::uint32_t side, const void* pixels,
                                      const void* colormap = nullptr, png_uint_32 entries = 0) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = image.height = side;
    image.format = format;
    image.colormap_entries = entries;
    png_alloc_size_t size = 0;
    EXPECT_TRUE(png_image_write_to_memory(&image, nullptr, &size, 0, pixels, 0, colormap));
    std::vector<std::uint8_t> bytes(size);
    EXPECT_TRUE(png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, 0, colormap));
    return bytes;
}

ExitCode code_of(const std::vector<std::uint8_t>& bytes) {
    try {
        decode_png(bytes, "test.png");
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("test.png"), std::string::npos) << e.what();
        return e.code();
    }
    return ExitCode::ok;
}

TEST(Png, RoundTrip8) {
    for (const auto& [w, h] :
         {std::pair<std::size_t, std::size_t>{1, 1}, {7, 3}, {256, 1}, {1, 300}, {333, 257}}) {
        const Image<Rgb8> image = pattern8(w, h);
        for (const int level : {0, 1, 6}) {
            EXPECT_EQ(decode_png(encode_png(image, level), "memory"), image) << w << "x" << h;
        }
    }
}

TEST(Png, FileRoundTrip) {
    const ScratchFolder folder;
    const Image<Rgb8> image = pattern8(19, 23);
    write_png(folder / "a.png", image);
    EXPECT_EQ(read_png(folder / "a.png"), image);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Png, SixteenBitsKeepAllBitsAndReduceByRounding) {
    Image<Rgb16> image(257, 3);
    for (std::size_t x = 0; x < 257; ++x) {
        for (std::size_t y = 0; y < 3; ++y) {
            image(x, y) = {std::uint16_t(x * 255), std::uint16_t(65535 - x),
                           std::uint16_t(y * 129)};
        }
    }
    const auto bytes = encode_png(image);
    EXPECT_EQ(big_endian(bytes, 16), 257u);
    EXPECT_EQ(bytes[24], 16) << "bit depth in IHDR";
    const Image<Rgb8> reduced = decode_png(bytes, "memory");
    for (std::size_t x = 0; x < 257; ++x) {
        EXPECT_EQ(reduced(x, 1).r, (image(x, 1).r * 255u + 32767u) / 65535u);
        EXPECT_EQ(reduced(x, 1).g, (image(x, 1).g * 255u + 32767u) / 65535u);
    }
}

TEST(Png, SixteenBitSamplesAreBigEndian) {
    Image<Rgb16> image(1, 1, {0x1234, 0xabcd, 0x00ff});
    const auto bytes =
        encode_png(image, 0);  // stored, so the samples stand in the file as they are
    const std::vector<std::uint8_t> row{0x12, 0x34, 0xab, 0xcd, 0x00, 0xff};
    EXPECT_NE(std::search(bytes.begin(), bytes.end(), row.begin(), row.end()), bytes.end());
}

TEST(Png, ComesPieceByPieceWithTheSameBytes) {
    const Image<Rgb8> image = pattern8(1000, 1500);  // nine bands
    std::vector<std::uint8_t> bytes;
    std::size_t largest = 0, pieces = 0;
    encode_png(image, [&](std::span<const std::uint8_t> piece) {
        bytes.insert(bytes.end(), piece.begin(), piece.end());
        largest = std::max(largest, piece.size());
        ++pieces;
    });
    EXPECT_EQ(bytes, encode_png(image));
    EXPECT_GT(pieces, 10u);
    EXPECT_LT(largest, bytes.size() / 4);
}

TEST(Png, WhatTheSinkThrowsComesOut) {
    const Error full(ExitCode::io, "a.png: the disk is full");
    std::size_t calls = 0;
    try {
        encode_png(pattern8(40, 40), [&](std::span<const std::uint8_t>) {
            if (++calls == 3) throw full;
        });
        FAIL() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::io);
        EXPECT_STREQ(error.what(), full.what());
    }
    EXPECT_EQ(calls, 3u);
}

TEST(Png, SaysItIsSrgb) {
    const auto bytes = encode_png(pattern8(2, 2));
    const std::string name = "sRGB";
    EXPECT_NE(std::search(bytes.begin(), bytes.end(), name.begin(), name.end()), bytes.end());
}

TEST(Png, ForeignKindsComeInAsRgb) {
    const std::vector<std::uint8_t> grey{0, 80, 160, 255};
    EXPECT_EQ(decode_png(foreign_png(PNG_FORMAT_GRAY, 2, grey.data()), "g")(1, 0),
              (Rgb8{80, 80, 80}));
    const std::vector<std::uint8_t> rgba{9, 8, 7, 0, 1, 2, 3, 128, 4, 5, 6, 255, 7, 7, 7, 7};
    const auto with_alpha = decode_png(foreign_png(PNG_FORMAT_RGBA, 2, rgba.data()), "a");
    EXPECT_EQ(with_alpha(0, 0), (Rgb8{9, 8, 7})) << "alpha is dropped, not blended";
    EXPECT_EQ(with_alpha(1, 0), (Rgb8{1, 2, 3}));
    const std::vector<std::uint8_t> indices{0, 1, 2, 1};
    const std::vector<std::uint8_t> map{10, 20, 30, 40, 50, 60, 70, 80, 90};
    const auto palette = foreign_png(PNG_FORMAT_RGB_COLORMAP, 2, indices.data(), map.data(), 3);
    EXPECT_EQ(decode_png(palette, "p")(1, 0), (Rgb8{40, 50, 60}));
    EXPECT_EQ(decode_png(palette, "p")(0, 1), (Rgb8{70, 80, 90}));
}

TEST(Png, InterlacedImagesComeInWhole) {
    const Image<Rgb8> image = pattern8(13, 9);
    std::vector<std::uint8_t> out;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto store = [](png_structp p, png_bytep data, std::size_t n) {
        auto* bytes = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(p));
        bytes->insert(bytes->end(), data, data + n);
    };
    png_set_write_fn(png, &out, store, [](png_structp) {});
    png_set_IHDR(png, info, 13, 9, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_ADAM7, 0, 0);
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < 9; ++y) {
        rows.push_back(const_cast<png_bytep>(&image.row(y)[0].r));
    }
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    png_destroy_write_struct(&png, &info);
    EXPECT_EQ(decode_png(out, "interlaced"), image);
}

TEST(Png, EveryTruncationIsRefused) {
    const auto bytes = encode_png(pattern8(40, 40));
    for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 50) {
        const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + std::ptrdiff_t(length));
        EXPECT_EQ(code_of(cut), ExitCode::invalid_file) << length;
    }
    EXPECT_EQ(code_of({bytes.begin(), bytes.end() - 1}), ExitCode::invalid_file);
}

TEST(Png, DamageIsRefused) {
    auto bytes = encode_png(pattern8(40, 40));
    bytes[bytes.size() / 2] ^= 0x55u;
    EXPECT_EQ(code_of(bytes), ExitCode::invalid_file);
    EXPECT_EQ(code_of({'P', '6', '\n'}), ExitCode::invalid_file);
}

TEST(Png, DeclaredSizesBeyondTheDataAllocateNothing) {
    auto bytes = encode_png(pattern8(4, 4));
    // 16000 x 16000 in IHDR, with a right checksum, over the data of 4 x 4.
    for (const std::size_t at : {std::size_t(16), std::size_t(20)}) {
        bytes[at + 2] = 16000 >> 8;
        bytes[at + 3] = 16000 & 255;
    }
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t i = 12; i < 29; ++i) {
        crc ^= bytes[i];
        for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ ((crc & 1u) ? 0xedb88320u : 0u);
    }
    crc = ~crc;
    for (std::size_t k = 0; k < 4; ++k) bytes[29 + k] = std::uint8_t(crc >> (24 - 8 * k));
    ASSERT_EQ(big_endian(bytes, 16), 16000u);
    try {
        decode_png(bytes, "bomb.png");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::invalid_file);
        EXPECT_NE(std::string(e.what()).find("too short"), std::string::npos) << e.what();
    }
}

TEST(Png, AlphaIsKeptWhereItIsAskedFor) {
    const auto alphas = [](const std::vector<std::uint8_t>& bytes) {
        std::vector<int> all;
        const PictureColors colors = decode_png_with_alpha(bytes, "a.png");
        if (const auto* image = std::get_if<Image<Rgba8>>(&colors))
            for (const Rgba8& p : image->pixels()) all.push_back(p.a);
        return all;
    };
    Image<Rgba8> image(2, 1);
    image(0, 0) = {1, 2, 3, 77};
    image(1, 0) = {250, 240, 230, 255};
    EXPECT_EQ(std::get<Image<Rgba8>>(decode_png_with_alpha(encode_png(image), "a")), image);
    EXPECT_EQ(std::get<Image<Rgb8>>(decode_png_with_alpha(encode_png(pattern8(5, 4)), "a")),
              pattern8(5, 4));
    const std::array<std::uint8_t, 8> grey{10, 0, 20, 100, 30, 200, 40, 255};
    EXPECT_EQ(alphas(foreign_png(PNG_FORMAT_GA, 2, grey.data())),
              (std::vector<int>{0, 100, 200, 255}));
    const std::array<std::uint8_t, 4> indices{0, 1, 1, 0};
    const std::array<std::uint8_t, 8> map{255, 0, 0, 255, 0, 255, 0, 51};
    EXPECT_EQ(alphas(foreign_png(PNG_FORMAT_RGBA_COLORMAP, 2, indices.data(), map.data(), 2)),
              (std::vector<int>{255, 51, 51, 255}));
}

TEST(Png, MissingFilesAndFoldersAreIoErrors) {
    const ScratchFolder folder;
    for (const std::string& path : {folder / "missing.png", folder.path()}) {
        try {
            read_png(path);
            FAIL() << path;
        } catch (const Error& e) {
            EXPECT_EQ(e.code(), ExitCode::io);
            EXPECT_NE(std::string(e.what()).find(path), std::string::npos);
        }
    }
}

TEST(Png, WhatDoesNotBeginAsOneIsNotRead) {
    const ScratchFolder folder;
    const std::string path = folder / "huge.png";
    write_file(path, "GIF89a");
    std::filesystem::resize_file(path, std::uintmax_t(1) << 33);
    try {
        read_png(path);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::invalid_file) << error.what();
    }
}

TEST(FileBytes, AreAsManyAsTheFileHas) {
    const ScratchFolder folder;
    const std::string path = folder / "a.bin", content(100000, 'x');
    write_file(path, content);
    const std::vector<std::uint8_t> bytes = read_file_bytes(path);
    EXPECT_TRUE(std::ranges::equal(bytes, content));
    EXPECT_LE(bytes.capacity(), content.size() + 1);
}

}  // namespace
}  // namespace burl
