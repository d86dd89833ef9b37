#pragma once
// PNG files, read through libpng, whose long jumps come out of image_io.cpp as Error, and written
// by png_write.cpp.
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/base/file_bytes.h"
#include "app/image/palette.h"
#include "atlas/base/image.h"
#include "atlas/base/task_meter.h"

namespace burl {

/// Reads any PNG as 8-bit RGB: grey and palettes are expanded, 16 bits are rounded to 8, alpha is
/// dropped, gamma chunks are ignored. Throws Error: io when the file cannot be read or is not a
/// regular file, invalid_file when it is not a PNG, is damaged or truncated, or has more than 2^28
/// pixels.
Image<Rgb8> read_png(const std::string& path);

/// The file's bytes, for decode_png. Throws Error: io as read_png does, invalid_file when they do
/// not begin with PNG's signature.
std::vector<std::uint8_t> read_png_bytes(const std::string& path);

struct PngSize {
    std::size_t width = 0, height = 0;
};
/// The size in pixels that a PNG file's header declares, which need not be true. Throws Error as
/// read_png does.
PngSize png_size(const std::string& path);

/// Reads bytes in memory as read_png reads a file; `origin` names them in messages.
Image<Rgb8> decode_png(std::span<const std::uint8_t> bytes, const std::string& origin);

/// The colours of a picture, with their alpha where the file has any.
using PictureColors = std::variant<Image<Rgb8>, Image<Rgba8>>;

/// Reads bytes in memory as decode_png does, but keeps alpha: that of an alpha channel, and that of
/// a palette's or a colour key's transparent colours.
PictureColors decode_png_with_alpha(std::span<const std::uint8_t> bytes, const std::string& origin);

/// The colours and, of an image that has it, alpha as images of their own.
std::pair<Image<Rgb8>, Image<Grey8>> colors_and_alpha(PictureColors image);

/// The meaning of the pixels: colours, which are marked as sRGB, or data such as normals.
enum class PngContent { color, data };
/// The meaning of pixels of which nothing else is said: grey ones are data.
template <class Pixel>
inline constexpr PngContent png_content =
    std::unsigned_integral<Pixel> ? PngContent::data : PngContent::color;

/// libdeflate's level of textures: half again as fast as one level more, for files 2 % larger
/// (docs/lab/export.md).
inline constexpr int png_level = 5;

/// The content of a PNG file, row 0 on top: RGB, RGBA or grey, of 8 or 16 bits, the codes as they
/// are. Pixel is Rgb8, Rgb16, Rgba8, Rgba16, Grey8 or Grey16. `level` is libdeflate's, 0 (stored)
/// to 12. Colours are marked as sRGB, numbers are not. The image has at
/// least one pixel. All threads of the caller's arena share the work, and the bytes are the same
/// for any number of them. Throws Error(runtime) for a side above 2^20.
template <class Pixel>
std::vector<std::uint8_t> encode_png(const Image<Pixel>& image, int level = png_level);

/// Passes the bytes to the sink as they are produced, by one thread at a time: beside a texture of
/// 16384 x 16384 texels there is no memory for its file. Exceptions of the sink are passed on. A
/// meter gets the bytes of pixels as they are encoded.
template <class Pixel>
void encode_png(const Image<Pixel>& image, const ByteSink& sink,
                PngContent content = png_content<Pixel>, TaskMeter* meter = nullptr);

/// A PNG with a palette, or in grey where all colours are grey, at libdeflate's level 9; for small
/// files.
std::vector<std::uint8_t> encode_png(const IndexedImage& image);

/// Writes the file, whole or not at all (app/base/atomic_file.h). Throws Error(io).
void write_png(const std::string& path, const Image<Rgb8>& image);

}  // namespace burl
