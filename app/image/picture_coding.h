#pragma once
// The formats of textures' pictures: PNG (image_io.h), JPEG, WebP and KTX2.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/image/image_io.h"

namespace burl {

enum class TextureFormat { png, jpeg, webp, ktx2 };

/// The extension of glTF that textures of WebP pictures need.
inline constexpr const char* webp_extension = "EXT_texture_webp";

/// A format, and how much its pictures may lose.
struct PictureCoding {
    TextureFormat format = TextureFormat::png;
    /// The quality of JPEG, 1 to 100, and of WebP, 0 to 100, which keeps every code; zstd's level
    /// of KTX2, 0 (stored) to 19. None: jpeg_quality, every code, and ktx2_level.
    std::optional<int> quality{};
    /// Gets the bytes of pixels as they are encoded; null: nobody does.
    TaskMeter* meter = nullptr;
};

/// The quality at which JPEG's worst texel of marble is off by 6 of 255 codes
/// (docs/lab/export.md).
inline constexpr int jpeg_quality = 90;
/// The least quality at which JPEG stores what is no colour, such as normals.
inline constexpr int jpeg_data_quality = 95;
/// zstd's own level.
inline constexpr int ktx2_level = 3;

/// The coding of "png", "jpeg", "webp" or "ktx2", with or without a number behind a colon. Throws
/// Error(usage) for another word, a number out of range and a number of png.
PictureCoding coding_named(const std::string& text);

/// The word of the format, its extension with the dot, and its media type.
std::string_view to_string(TextureFormat format);
std::string_view extension_of(TextureFormat format);
std::string_view media_type(TextureFormat format);

/// The format of a file of this name (any case, .jpg or .jpeg); none for another extension.
std::optional<TextureFormat> texture_format_of(const std::string& path);

/// The largest side in pixels that the format has.
std::size_t most_pixels(TextureFormat format);

/// Writes the picture as encode_png() does, in the coding's format. What is no colour keeps every
/// code of WebP, and in JPEG gets at least jpeg_data_quality; JPEG's chroma has full resolution,
/// since charts of an atlas have neighbours of other colours. Throws Error: unsupported for alpha
/// in JPEG, 16 bits in all but PNG and a picture that is too large for the format, and runtime
/// where a library fails.
template <class Pixel>
void encode_picture(const Image<Pixel>& image, const ByteSink& sink, const PictureCoding& coding,
                    PngContent content = png_content<Pixel>);

/// Rows of pixels of 8 bits, of 1, 3 or 4 components. Encoders tell a meter their bytes.
struct CodeRaster {
    const std::uint8_t* pixels;
    std::size_t width, height, components;

    std::size_t stride() const { return width * components; }
};

/// The raster of an image of 8 bits, which it refers to.
template <class Pixel>
CodeRaster codes_of(const Image<Pixel>& image) {
    return {reinterpret_cast<const std::uint8_t*>(image.pixels().data()), image.width(),
            image.height(), sizeof(Pixel)};
}

/// Passes a JPEG file to the sink, grey or YCbCr (JFIF) without subsampling. Up to 2^26 pixels its
/// Huffman codes are made for it; beyond, rows go out as they come, in little memory. Throws
/// Error(runtime).
void encode_jpeg(const CodeRaster& raster, const ByteSink& sink, int quality,
                 TaskMeter* meter = nullptr);

/// Passes a WebP file to the sink; quality 100 keeps every code, also of what is transparent. Needs
/// memory for the picture and its file. Throws Error(runtime).
void encode_webp(const CodeRaster& raster, const ByteSink& sink, int quality,
                 TaskMeter* meter = nullptr);

/// Passes a KTX2 file (Khronos, "KTX File Format Specification" 2.0) to the sink: level l has
/// max(1, floor(n / 2^l)) pixels a side. One component becomes R8, three or four R8G8B8A8, since
/// few graphics processors have textures of 24 bits; sRGB for colours, UNORM for data. `level` is
/// zstd's; 0 stores the texels as they are. Needs memory for the compressed levels. Throws
/// Error(runtime).
void encode_ktx2(std::span<const CodeRaster> levels, const ByteSink& sink, int level,
                 PngContent content, TaskMeter* meter = nullptr);

}  // namespace burl
