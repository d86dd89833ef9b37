#pragma once
// Animations as other programs see them: .webp through libwebp's demuxer, .gif through giflib's
// reader, .apng chunk by chunk with a checksum of our own, its frames through libpng.
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <gif_lib.h>
#include <gtest/gtest.h>
#include <webp/decode.h>
#include <webp/demux.h>

#include "app/image/image_io.h"

namespace burl {

/// The whole canvas after each frame, and how long it is shown.
struct DecodedFrames {
    std::vector<Image<Rgba8>> frames;
    std::vector<int> milliseconds;
    int plays = -1;                            ///< 0: for ever
    std::vector<std::size_t> stored_pixels{};  ///< per frame of .gif and .apng, the rectangle's

    int duration() const {
        int sum = 0;
        for (const int one : milliseconds) sum += one;
        return sum;
    }
};

inline std::vector<std::uint8_t> bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline Image<Rgba8> canvas_of(const std::uint8_t* rgba, std::size_t width, std::size_t height) {
    Image<Rgba8> image(width, height);
    std::memcpy(image.row(0).data(), rgba, 4 * width * height);
    return image;
}

inline DecodedFrames decoded_webp(const std::string& path) {
    const std::vector<std::uint8_t> bytes = bytes_of(path);
    const ::WebPData data{bytes.data(), bytes.size()};
    DecodedFrames result;
    ::WebPAnimDecoderOptions options;
    ::WebPAnimDecoderOptionsInit(&options);
    ::WebPAnimDecoder* decoder = ::WebPAnimDecoderNew(&data, &options);
    ::WebPAnimInfo info{};
    if (!decoder || !::WebPAnimDecoderGetInfo(decoder, &info)) return result;
    result.plays = int(info.loop_count);
    for (int before = 0; ::WebPAnimDecoderHasMoreFrames(decoder);) {
        std::uint8_t* rgba = nullptr;
        int end = 0;
        if (!::WebPAnimDecoderGetNext(decoder, &rgba, &end)) break;
        result.frames.push_back(canvas_of(rgba, info.canvas_width, info.canvas_height));
        result.milliseconds.push_back(end - before);
        before = end;
    }
    ::WebPAnimDecoderDelete(decoder);
    return result;
}

/// Draws a frame of a GIF over what was there.
inline void draw_gif_frame(const ::SavedImage& saved, int transparent, Image<Rgba8>& canvas) {
    const ::GifImageDesc& at = saved.ImageDesc;
    for (int y = 0; y < at.Height; ++y)
        for (int x = 0; x < at.Width; ++x) {
            const int index = saved.RasterBits[y * at.Width + x];
            if (index == transparent) continue;
            const ::GifColorType& c = at.ColorMap->Colors[index];
            canvas(std::size_t(at.Left + x), std::size_t(at.Top + y)) = {c.Red, c.Green, c.Blue,
                                                                         255};
        }
}

inline DecodedFrames decoded_gif(const std::string& path) {
    DecodedFrames result;
    int error = 0;
    ::GifFileType* gif = ::DGifOpenFileName(path.c_str(), &error);
    if (!gif) return result;
    if (::DGifSlurp(gif) != GIF_OK) ADD_FAILURE() << ::GifErrorString(gif->Error);
    Image<Rgba8> canvas{std::size_t(gif->SWidth), std::size_t(gif->SHeight)};
    for (int i = 0; i < gif->ImageCount; ++i) {
        const ::SavedImage& saved = gif->SavedImages[i];
        ::GraphicsControlBlock control{DISPOSAL_UNSPECIFIED, false, 0, NO_TRANSPARENT_COLOR};
        ::DGifSavedExtensionToGCB(gif, i, &control);
        draw_gif_frame(saved, control.TransparentColor, canvas);
        result.frames.push_back(canvas);
        result.milliseconds.push_back(10 * control.DelayTime);
        result.stored_pixels.push_back(std::size_t(saved.ImageDesc.Width) *
                                       std::size_t(saved.ImageDesc.Height));
        if (control.DisposalMode == DISPOSE_BACKGROUND)
            canvas = Image<Rgba8>(canvas.width(), canvas.height());
        for (int k = 0; k + 1 < saved.ExtensionBlockCount; ++k)
            if (saved.ExtensionBlocks[k].ByteCount == 11 &&
                std::memcmp(saved.ExtensionBlocks[k].Bytes, "NETSCAPE2.0", 11) == 0)
                result.plays = saved.ExtensionBlocks[k + 1].Bytes[1];
    }
    ::DGifCloseFile(gif, &error);
    return result;
}

inline std::uint32_t big_endian(std::span<const std::uint8_t> bytes, int count = 4) {
    std::uint32_t number = 0;
    for (int i = 0; i < count; ++i) number = number << 8 | bytes[std::size_t(i)];
    return number;
}

/// The checksum of PNG's chunks, bit by bit (W3C, "PNG Specification", annex D).
inline std::uint32_t png_checksum(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = ~0u;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    }
    return ~crc;
}

inline void append_chunk(std::vector<std::uint8_t>& png, const char* type,
                         std::span<const std::uint8_t> data) {
    std::vector<std::uint8_t> body(type, type + 4);
    body.insert(body.end(), data.begin(), data.end());
    const auto number = [&](std::size_t n) {
        for (const int shift : {24, 16, 8, 0}) png.push_back(std::uint8_t(n >> shift));
    };
    number(data.size());
    png.insert(png.end(), body.begin(), body.end());
    number(png_checksum(body));
}

/// The frames of an .apng; checks that chunks stand in their order, with right checksums.
class ApngReader {
  public:
    explicit ApngReader(const std::string& path) : bytes_(bytes_of(path)) {
        std::span<const std::uint8_t> rest(bytes_);
        for (rest = rest.subspan(8); rest.size() >= 12;) {
            const std::size_t length = big_endian(rest);
            const std::string type(reinterpret_cast<const char*>(&rest[4]), 4);
            EXPECT_EQ(big_endian(rest.subspan(8 + length)),
                      png_checksum(rest.subspan(4, 4 + length)))
                << type;
            read(type, rest.subspan(8, length));
            rest = rest.subspan(length + 12);
        }
        EXPECT_EQ(last_, "IEND");
        EXPECT_EQ(result_.frames.size(), std::size_t(declared_));
    }
    DecodedFrames take() { return result_; }

  private:
    void read(const std::string& type, std::span<const std::uint8_t> data) {
        if (type == "IHDR") {
            header_.assign(data.begin(), data.end());
            canvas_ = {big_endian(data), big_endian(data.subspan(4))};
        } else if (type == "acTL") {
            EXPECT_EQ(last_, "IHDR");
            declared_ = int(big_endian(data));
            result_.plays = int(big_endian(data.subspan(4)));
        } else if (type == "fcTL") {
            finish_frame();
            EXPECT_EQ(big_endian(data), sequence_++);
            control_.assign(data.begin(), data.end());
        } else if (type == "IDAT") {
            data_.insert(data_.end(), data.begin(), data.end());
        } else if (type == "fdAT") {
            EXPECT_EQ(big_endian(data), sequence_++);
            data_.insert(data_.end(), data.begin() + 4, data.end());
        } else if (type == "IEND") {
            finish_frame();
        }
        last_ = type;
    }

    /// Decodes the frame that the last fcTL began, as a PNG of its own.
    void finish_frame() {
        if (control_.empty()) return;
        const std::span<const std::uint8_t> control(control_);
        std::copy_n(control.begin() + 4, 8, header_.begin());
        std::vector<std::uint8_t> png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
        append_chunk(png, "IHDR", header_);
        append_chunk(png, "IDAT", data_);
        append_chunk(png, "IEND", {});
        const PictureColors colors = decode_png_with_alpha(png, "a frame");
        const std::size_t left = big_endian(control.subspan(12)),
                          top = big_endian(control.subspan(16));
        std::visit([&](const auto& image) { place(image, left, top); }, colors);
        result_.frames.push_back(canvas_);
        const std::uint32_t ticks = big_endian(control.subspan(20), 2);
        result_.milliseconds.push_back(int(1000 * ticks / big_endian(control.subspan(22), 2)));
        result_.stored_pixels.push_back(big_endian(control.subspan(4)) *
                                        big_endian(control.subspan(8)));
        EXPECT_EQ(big_endian(control.subspan(24), 2), 0u) << "replaced, and left in place";
        data_.clear();
    }

    template <class Pixel>
    void place(const Image<Pixel>& image, std::size_t left, std::size_t top) {
        for (std::size_t y = 0; y < image.height(); ++y)
            for (std::size_t x = 0; x < image.width(); ++x) {
                const Pixel& p = image(x, y);
                Rgba8& to = canvas_(left + x, top + y);
                if constexpr (requires { p.a; })
                    to = p;
                else
                    to = {p.r, p.g, p.b, 255};
            }
    }

    std::vector<std::uint8_t> bytes_, header_, control_, data_;
    Image<Rgba8> canvas_;
    DecodedFrames result_;
    std::string last_;
    int declared_ = -1;
    std::uint32_t sequence_ = 0;
};

inline DecodedFrames decoded_apng(const std::string& path) {
    return ApngReader(path).take();
}

/// The frames of a file by its extension.
inline DecodedFrames decoded_frames(const std::string& path) {
    if (path.ends_with(".webp")) return decoded_webp(path);
    if (path.ends_with(".gif")) return decoded_gif(path);
    return decoded_apng(path);
}

inline Image<Rgba8> opaque(const Image<Rgb8>& image) {
    return converted<Rgba8>(image, [](const Rgb8& c) { return Rgba8{c.r, c.g, c.b, 255}; });
}

}  // namespace burl
