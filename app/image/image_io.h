#pragma once
// PNG in and out, through libpng. Nothing of libpng shows: its long jumps stay inside image_io.cpp
// and come out as Error.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/base/byte_sink.h"
#include "app/image/palette.h"
#include "atlas/base/image.h"

namespace burl {

/// zlib level of encode_png. Level 1 goes with one row filter (Paeth) and run-length matching: on
/// solid textures several times faster than zlib's default 6 for 3 % more bytes
/// (docs/lab/export.md).
inline constexpr int default_png_level = 1;

/// Any PNG as 8-bit RGB: grey and palette are expanded, 16 bits are rounded to 8, alpha is dropped,
/// gamma chunks are ignored. Throws Error: io when the file cannot be read or is no regular file,
/// invalid_file when it is no PNG, damaged, truncated, or larger than 2^28 pixels.
Image<Rgb8> read_png(const std::string& path);

/// The file's bytes, for decode_png. Throws Error: io as read_png does, invalid_file when it does
/// not begin as a PNG does.
std::vector<std::uint8_t> read_png_bytes(const std::string& path);

/// The size that a PNG file's head declares, which need not be true. Throws Error as
/// read_png does.
struct PngSize {
    std::size_t width = 0, height = 0;
};
PngSize png_size(const std::string& path);

/// Reads bytes in memory as read_png reads a file; `origin` names them in messages.
Image<Rgb8> decode_png(std::span<const std::uint8_t> bytes, const std::string& origin);

/// Colours are marked sRGB; data (normals) must not be taken for colours.
enum class PngContent { color, data };

/// PNG file content, row 0 on top. `level` 0..9 is zlib's. The image has at least one
/// pixel. Throws Error(runtime) when it cannot be encoded (too large).
std::vector<std::uint8_t> encode_png(const Image<Rgb8>& image, int level = default_png_level,
                                     PngContent content = PngContent::color);
std::vector<std::uint8_t> encode_png(const Image<Rgb16>& image, int level = default_png_level,
                                     PngContent content = PngContent::color);

/// The same bytes to a sink as they come: beside a texture of 16384 x 16384 texels there is no room
/// for its file. What the sink throws comes out.
void encode_png(const Image<Rgb8>& image, const ByteSink& sink,
                PngContent content = PngContent::color);
void encode_png(const Image<Rgb16>& image, const ByteSink& sink,
                PngContent content = PngContent::color);

/// A PNG with a palette, at zlib's level 9 (grey levels alone: without one); for small files.
std::vector<std::uint8_t> encode_png(const IndexedImage& image);

/// Writes the file whole or not at all (app/base/atomic_file.h). Throws Error(io).
void write_png(const std::string& path, const Image<Rgb8>& image);
void write_png(const std::string& path, const Image<Rgb16>& image);

}  // namespace burl
