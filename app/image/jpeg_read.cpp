// libjpeg reports errors by longjmp: what calls it after setjmp holds nothing with a destructor.
#include "app/image/jpeg_read.h"

#include <array>
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include "app/base/file_bytes.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

constexpr std::uint64_t most_jpeg_pixels = 1ull << 28;

/// libjpeg's error handler, and where it jumps.
struct JpegReadErrors {
    ::jpeg_error_mgr manager{};  // the first member, since libjpeg knows its address only
    std::jmp_buf jump;
    std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void on_read_error(::j_common_ptr jpeg) {
    auto* errors = reinterpret_cast<JpegReadErrors*>(jpeg->err);
    errors->manager.format_message(jpeg, errors->message.data());
    std::longjmp(errors->jump, 1);
}

/// Makes a warning, such as that of a file that ends too early, an error.
void on_read_message(::j_common_ptr jpeg, int level) {
    if (level < 0) on_read_error(jpeg);
}

/// Owner of libjpeg's struct for reading.
struct JpegReader {
    JpegReadErrors errors;
    ::jpeg_decompress_struct jpeg{};

    JpegReader() {
        jpeg.err = ::jpeg_std_error(&errors.manager);
        errors.manager.error_exit = on_read_error;
        errors.manager.emit_message = on_read_message;
    }
    ~JpegReader() { ::jpeg_destroy_decompress(&jpeg); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
};

/// Reads the headers; false after an error.
bool read_jpeg_header(JpegReader& r, const std::uint8_t* bytes, std::size_t count) {
    if (setjmp(r.errors.jump)) return false;
    ::jpeg_create_decompress(&r.jpeg);
    ::jpeg_mem_src(&r.jpeg, bytes, static_cast<unsigned long>(count));
    ::jpeg_read_header(&r.jpeg, TRUE);
    return true;
}

/// Reads all rows; false after an error.
bool read_jpeg_rows(JpegReader& r, std::uint8_t* pixels, std::size_t stride) {
    if (setjmp(r.errors.jump)) return false;
    r.jpeg.out_color_space = JCS_RGB;
    ::jpeg_start_decompress(&r.jpeg);
    while (r.jpeg.output_scanline < r.jpeg.output_height) {
        ::JSAMPROW row = pixels + stride * r.jpeg.output_scanline;
        ::jpeg_read_scanlines(&r.jpeg, &row, 1);
    }
    ::jpeg_finish_decompress(&r.jpeg);
    return true;
}

Error damaged_jpeg(const JpegReader& reader, const std::string& origin) {
    return invalid_file(origin, 0,
                        fmt::format("damaged JPEG image: {}", reader.errors.message.data()));
}

void open_jpeg(JpegReader& reader, std::span<const std::uint8_t> bytes, const std::string& origin) {
    if (!read_jpeg_header(reader, bytes.data(), bytes.size())) throw damaged_jpeg(reader, origin);
    if (std::uint64_t{reader.jpeg.image_width} * reader.jpeg.image_height > most_jpeg_pixels)
        throw invalid_file(origin, 0, "the image has more than 2^28 pixels");
    if (reader.jpeg.num_components == 4)
        throw invalid_file(origin, 0, "this JPEG has four channels (CMYK); save it as RGB");
}

constexpr std::uint64_t most_jpeg_bytes = 1ull << 30;

bool is_jpeg_file(const std::string& path) {
    return is_jpeg(read_file_head(path, 3));
}

}  // namespace

bool is_jpeg(std::span<const std::uint8_t> bytes) {
    return bytes.size() > 2 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

PngSize jpeg_size(std::span<const std::uint8_t> bytes, const std::string& origin) {
    JpegReader reader;
    open_jpeg(reader, bytes, origin);
    return {reader.jpeg.image_width, reader.jpeg.image_height};
}

Image<Rgb8> decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& origin) {
    static_assert(sizeof(Rgb8) == 3, "pixels are libjpeg's rows");
    JpegReader reader;
    open_jpeg(reader, bytes, origin);
    Image<Rgb8> image(reader.jpeg.image_width, reader.jpeg.image_height);
    auto* pixels = reinterpret_cast<std::uint8_t*>(image.row(0).data());
    if (!read_jpeg_rows(reader, pixels, image.width() * sizeof(Rgb8)))
        throw damaged_jpeg(reader, origin);
    return image;
}

PngSize picture_size(const std::string& path) {
    if (!is_jpeg_file(path)) return png_size(path);
    return jpeg_size(read_regular_file(path, most_jpeg_bytes), path);
}

std::vector<std::uint8_t> read_picture_bytes(const std::string& path) {
    if (!is_jpeg_file(path)) return read_png_bytes(path);
    return read_regular_file(path, most_jpeg_bytes);
}

PngColors decode_picture(std::span<const std::uint8_t> bytes, const std::string& origin) {
    if (is_jpeg(bytes)) return decode_jpeg(bytes, origin);
    return decode_png_with_alpha(bytes, origin);
}

}  // namespace burl
