#include "app/exr_io.h"

#include <exception>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>

#include "app/atomic_file.h"
#include "app/exr_stream.h"
#include "atlas/error.h"

namespace burl {
namespace {

template <class Component>
Imf::FrameBuffer frame_of(const Rgb<Component>* pixels, std::size_t width, Imf::PixelType type) {
    // OpenEXR's slices take char* although they are only read here.
    auto* base = const_cast<char*>(reinterpret_cast<const char*>(pixels));
    constexpr std::size_t step = sizeof(Rgb<Component>);
    Imf::FrameBuffer frame;
    const char* names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        frame.insert(names[c], Imf::Slice(type, base + c * sizeof(Component), step, step * width));
    }
    return frame;
}

template <class Component>
void write_pixels(Imf::OutputFile& file, const Rgb<Component>* pixels, std::size_t width,
                  std::size_t height, Imf::PixelType type) {
    file.setFrameBuffer(frame_of(pixels, width, type));
    file.writePixels(int(height));
}

template <class Component>
void write_level(Imf::TiledOutputFile& file, int level, const Rgb<Component>* pixels,
                 std::size_t width, Imf::PixelType type) {
    file.setFrameBuffer(frame_of(pixels, width, type));
    file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
}

std::vector<Rgb<Imath::half>> to_half(const Image<RgbF>& image) {
    std::vector<Rgb<Imath::half>> pixels;
    pixels.reserve(image.pixels().size());
    for (const RgbF& p : image.pixels()) {
        pixels.push_back({Imath::half(p.r), Imath::half(p.g), Imath::half(p.b)});
    }
    return pixels;
}

Imf::Header header_of(const Image<RgbF>& image, Imf::PixelType type) {
    Imf::Header header(int(image.width()), int(image.height()));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(type));
    return header;
}

void encode_levels_into(std::vector<std::uint8_t>& bytes, std::span<const Image<RgbF>> levels,
                        ExrDepth depth) {
    const Imf::PixelType type = depth == ExrDepth::half ? Imf::HALF : Imf::FLOAT;
    Imf::Header header = header_of(levels[0], type);
    header.setTileDescription({64, 64, Imf::MIPMAP_LEVELS, Imf::ROUND_DOWN});
    ExrStream stream(bytes);
    Imf::TiledOutputFile file(stream, header);
    for (int l = 0; l < file.numLevels(); ++l) {
        const Image<RgbF>& image = levels[std::size_t(l)];
        if (depth == ExrDepth::half) {
            write_level(file, l, to_half(image).data(), image.width(), type);
        } else {
            write_level(file, l, image.pixels().data(), image.width(), type);
        }
    }
}

void encode_into(std::vector<std::uint8_t>& bytes, const Image<RgbF>& image, ExrDepth depth) {
    const Imf::PixelType type = depth == ExrDepth::half ? Imf::HALF : Imf::FLOAT;
    const Imf::Header header = header_of(image, type);
    ExrStream stream(bytes);
    Imf::OutputFile file(stream, header);
    if (depth == ExrDepth::half) {
        write_pixels(file, to_half(image).data(), image.width(), image.height(), type);
    } else {
        write_pixels(file, image.pixels().data(), image.width(), image.height(), type);
    }
}

Error not_encoded(const Image<RgbF>& image, const std::exception& e) {
    return Error(ExitCode::runtime,
                 fmt::format("the OpenEXR image of {} x {} could not be encoded: {}", image.width(),
                             image.height(), e.what()));
}

}  // namespace

std::vector<std::uint8_t> encode_exr(const Image<RgbF>& image, ExrDepth depth) {
    std::vector<std::uint8_t> bytes;
    try {
        encode_into(bytes, image, depth);
    } catch (const std::exception& e) {
        throw not_encoded(image, e);
    }
    return bytes;
}

std::vector<std::uint8_t> encode_exr_levels(std::span<const Image<RgbF>> levels, ExrDepth depth) {
    std::vector<std::uint8_t> bytes;
    try {
        encode_levels_into(bytes, levels, depth);
    } catch (const std::exception& e) {
        throw not_encoded(levels[0], e);
    }
    return bytes;
}

void write_exr(const std::string& path, const Image<RgbF>& image, ExrDepth depth) {
    write_file(path, encode_exr(image, depth));
}

void write_exr_levels(const std::string& path, std::span<const Image<RgbF>> levels,
                      ExrDepth depth) {
    write_file(path, encode_exr_levels(levels, depth));
}

}  // namespace burl
