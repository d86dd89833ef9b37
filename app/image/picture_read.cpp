// JPEG through libjpeg-turbo, which reports errors by longjmp: what calls it after setjmp holds
// nothing with a destructor. WebP through libwebp.
#include "app/image/picture_read.h"

#include <string_view>

#include <webp/decode.h>

#include "app/base/file_bytes.h"
#include "app/image/jpeg_errors.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

constexpr std::uint64_t most_read_pixels = 1ull << 28;
/// Pixels of a block whose coefficients are coded in a bit a component, in the coarsest sampling:
/// no byte of a JPEG stands for more.
constexpr std::uint64_t most_pixels_a_byte = 1024;
/// No file of 2^28 pixels in a format that is read is longer.
constexpr std::uint64_t most_picture_bytes = (most_read_pixels * 8) + (1u << 24);

/// Stops at the warnings after which pixels are made up.
void on_read_message(::j_common_ptr jpeg, int level) {
    const int code = jpeg->err->msg_code;
    const bool lost = code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER ||
                      code == JWRN_HUFF_BAD_CODE || code == JWRN_MUST_RESYNC;
    if (level < 0 && lost) on_jpeg_error(jpeg);
}

/// The owner of libjpeg's struct.
struct JpegReader {
    ::jpeg_decompress_struct jpeg{};
    JpegErrors errors;

    JpegReader() {
        jpeg.err = ::jpeg_std_error(&errors.manager);
        errors.manager.error_exit = on_jpeg_error;
        errors.manager.emit_message = on_read_message;
    }
    ~JpegReader() { ::jpeg_destroy_decompress(&jpeg); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
};

bool read_jpeg_head(JpegReader& reader, std::span<const std::uint8_t> bytes) {
    if (setjmp(reader.errors.jump)) return false;
    ::jpeg_create_decompress(&reader.jpeg);
    ::jpeg_mem_src(&reader.jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
    ::jpeg_read_header(&reader.jpeg, TRUE);
    return true;
}

bool read_jpeg_rows(JpegReader& reader, Image<Rgb8>& image) {
    if (setjmp(reader.errors.jump)) return false;
    reader.jpeg.out_color_space = JCS_RGB;
    reader.jpeg.dct_method = JDCT_ISLOW;
    ::jpeg_start_decompress(&reader.jpeg);
    while (reader.jpeg.output_scanline < reader.jpeg.output_height) {
        auto* row = reinterpret_cast<::JSAMPROW>(image.row(reader.jpeg.output_scanline).data());
        ::jpeg_read_scanlines(&reader.jpeg, &row, 1);
    }
    ::jpeg_finish_decompress(&reader.jpeg);
    return true;
}

Error damaged(const std::string& origin, PictureType type, std::string_view why) {
    return invalid_file(origin, 0, fmt::format("damaged {} image: {}", to_string(type), why));
}

Error damaged_jpeg(const JpegReader& reader, const std::string& origin) {
    return damaged(origin, PictureType::jpeg, reader.errors.message.data());
}

/// Reads the head. Throws Error for what is not read.
void open_jpeg(JpegReader& reader, std::span<const std::uint8_t> bytes, const std::string& origin) {
    if (!read_jpeg_head(reader, bytes)) throw damaged_jpeg(reader, origin);
    if (reader.jpeg.num_components == 4)
        throw Error(
            ExitCode::unsupported,
            fmt::format("{}: a JPEG of four components (CMYK) is not read; convert it to RGB",
                        origin));
    const std::uint64_t pixels = std::uint64_t(reader.jpeg.image_width) * reader.jpeg.image_height;
    if (pixels > most_read_pixels)
        throw damaged(origin, PictureType::jpeg, "the image has more than 2^28 pixels");
    if (pixels / most_pixels_a_byte > bytes.size())
        throw damaged(origin, PictureType::jpeg,
                      "the file is too short for the size it declares (truncated)");
}

Image<Rgb8> decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& origin) {
    JpegReader reader;
    open_jpeg(reader, bytes, origin);
    Image<Rgb8> image(reader.jpeg.image_width, reader.jpeg.image_height);
    if (!read_jpeg_rows(reader, image)) throw damaged_jpeg(reader, origin);
    return image;
}

template <class Pixel>
Image<Pixel> decode_webp(std::span<const std::uint8_t> bytes, const ::WebPBitstreamFeatures& has,
                         const std::string& origin) {
    Image<Pixel> image(std::size_t(has.width), std::size_t(has.height));
    auto* out = reinterpret_cast<std::uint8_t*>(image.row(0).data());
    const std::size_t stride = image.width() * sizeof(Pixel), size = stride * image.height();
    const auto decode = sizeof(Pixel) == 4 ? ::WebPDecodeRGBAInto : ::WebPDecodeRGBInto;
    if (!decode(bytes.data(), bytes.size(), out, size, int(stride)))
        throw damaged(origin, PictureType::webp, "its pixels cannot be decoded (truncated?)");
    return image;
}

::WebPBitstreamFeatures webp_head(std::span<const std::uint8_t> bytes, const std::string& origin) {
    ::WebPBitstreamFeatures has;
    if (::WebPGetFeatures(bytes.data(), bytes.size(), &has) != VP8_STATUS_OK)
        throw damaged(origin, PictureType::webp, "it has no head");
    if (has.format == 0 && !has.has_animation)
        throw damaged(origin, PictureType::webp, "it ends before its pixels (truncated)");
    if (std::uint64_t(has.width) * std::uint64_t(has.height) > most_read_pixels)
        throw damaged(origin, PictureType::webp, "the image has more than 2^28 pixels");
    return has;
}

PictureColors decode_webp(std::span<const std::uint8_t> bytes, const std::string& origin) {
    const ::WebPBitstreamFeatures has = webp_head(bytes, origin);
    if (has.has_animation)
        throw Error(
            ExitCode::unsupported,
            fmt::format("{}: an animated WebP is not read; give one of its frames", origin));
    if (has.has_alpha) return decode_webp<Rgba8>(bytes, has, origin);
    return decode_webp<Rgb8>(bytes, has, origin);
}

}  // namespace

PictureType picture_type(std::span<const std::uint8_t> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\x89PNG\r\n\x1a\n")) return PictureType::png;
    if (text.starts_with("\xff\xd8\xff")) return PictureType::jpeg;
    if (text.starts_with("RIFF") && text.size() > 12 && text.substr(8, 4) == "WEBP")
        return PictureType::webp;
    return text.starts_with("\xabKTX 20") ? PictureType::ktx2 : PictureType::unknown;
}

PictureColors decode_picture(std::span<const std::uint8_t> bytes, const std::string& origin) {
    const PictureType type = picture_type(bytes);
    if (type == PictureType::png) return decode_png_with_alpha(bytes, origin);
    if (type == PictureType::jpeg) return decode_jpeg(bytes, origin);
    if (type == PictureType::webp) return decode_webp(bytes, origin);
    throw Error(ExitCode::unsupported,
                fmt::format("{} is {}; convert it to {}", origin, to_string(type), pictures_read));
}

std::vector<std::uint8_t> read_picture_bytes(const std::string& path) {
    if (!is_read(picture_type(read_file_head(path, 16))))
        throw invalid_file(path, 0, fmt::format("this is no {} image", pictures_read));
    return read_regular_file(path, most_picture_bytes);
}

PictureColors read_picture(const std::string& path) {
    return decode_picture(read_picture_bytes(path), path);
}

PngSize picture_size(const std::string& path) {
    if (picture_type(read_file_head(path, 16)) == PictureType::png) return png_size(path);
    const std::vector<std::uint8_t> bytes = read_picture_bytes(path);
    if (picture_type(bytes) == PictureType::webp) {
        const ::WebPBitstreamFeatures has = webp_head(bytes, path);
        return {std::size_t(has.width), std::size_t(has.height)};
    }
    JpegReader reader;
    open_jpeg(reader, bytes, path);
    return {reader.jpeg.image_width, reader.jpeg.image_height};
}

}  // namespace burl
