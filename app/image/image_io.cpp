// PNG through libpng's row interface. libpng reports errors by longjmp, so every function that
// calls it after setjmp holds nothing with a destructor, and callbacks let no exception out.
#include "app/image/image_io.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>

#include <png.h>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

static_assert(sizeof(Rgb8) == 3 && sizeof(Rgb16) == 6, "pixels are libpng's rows");
static_assert(sizeof(Rgba8) == 4 && sizeof(Rgba16) == 8, "pixels are libpng's rows");

constexpr png_uint_32 max_side = 1u << 20;
constexpr std::uint64_t max_pixels = 1ull << 28;
/// The size in bytes of 2^28 pixels of 16-bit RGBA, and 16 MiB more for all else.
constexpr std::uint64_t most_file_bytes = (max_pixels * 8) + (1u << 24);
constexpr std::uint64_t max_deflate_ratio = 1032;  // zlib's limit

struct Message {
    char text[200] = "unknown error";
};

void on_error(png_structp png, png_const_charp message) {
    auto* kept = static_cast<Message*>(png_get_error_ptr(png));
    std::strncpy(kept->text, message, sizeof kept->text - 1);
    kept->text[sizeof kept->text - 1] = '\0';
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct Source {
    std::span<const std::uint8_t> rest;
};

void on_read(png_structp png, png_bytep out, std::size_t count) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (count > source->rest.size()) png_error(png, "the file ends too early (truncated)");
    std::memcpy(out, source->rest.data(), count);
    source->rest = source->rest.subspan(count);
}

/// Owner of libpng's two structs for reading.
struct Reader {
    Message message;
    Source source;
    std::size_t size;
    png_structp png;
    png_infop info = nullptr;
    int passes = 1;

    explicit Reader(std::span<const std::uint8_t> bytes)
        : source{bytes},
          size(bytes.size()),
          png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, on_error, on_warning)) {
        if (png) info = png_create_info_struct(png);
    }
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
};

void refuse_hostile_size(Reader& r) {
    const std::uint64_t width = png_get_image_width(r.png, r.info);
    const std::uint64_t height = png_get_image_height(r.png, r.info);
    if (width * height > max_pixels) png_error(r.png, "the image has more than 2^28 pixels");
    const std::uint64_t raw = png_get_rowbytes(r.png, r.info) * height;
    if (raw / max_deflate_ratio > r.size) {
        png_error(r.png, "the file is too short for the size it declares (truncated)");
    }
}

/// Reads the header and sets up the conversion to 8-bit rows, RGB, or RGBA where there is alpha
/// that is to be kept; false after a libpng error.
bool read_header(Reader& r, bool keeps_alpha = false) {
    if (setjmp(png_jmpbuf(r.png))) return false;
    png_set_user_limits(r.png, max_side, max_side);
    png_set_read_fn(r.png, &r.source, on_read);
    png_read_info(r.png, r.info);
    refuse_hostile_size(r);
    png_set_palette_to_rgb(r.png);
    png_set_expand_gray_1_2_4_to_8(r.png);
    png_set_gray_to_rgb(r.png);
    png_set_scale_16(r.png);
    if (!keeps_alpha)
        png_set_strip_alpha(r.png);
    else if (png_get_valid(r.png, r.info, PNG_INFO_tRNS))
        png_set_tRNS_to_alpha(r.png);
    r.passes = png_set_interlace_handling(r.png);
    png_read_update_info(r.png, r.info);
    return true;
}

bool read_rows(Reader& r, std::uint8_t* pixels, std::size_t stride, std::size_t height) {
    if (setjmp(png_jmpbuf(r.png))) return false;
    if (png_get_rowbytes(r.png, r.info) != stride) png_error(r.png, "unexpected row size");
    for (int pass = 0; pass < r.passes; ++pass) {
        for (std::size_t y = 0; y < height; ++y) {
            png_read_row(r.png, pixels + y * stride, nullptr);
        }
    }
    png_read_end(r.png, nullptr);
    return true;
}

void refuse_other_formats(std::span<const std::uint8_t> bytes, const std::string& origin) {
    if (bytes.empty() || png_sig_cmp(bytes.data(), 0, std::min<std::size_t>(8, bytes.size())))
        throw invalid_file(origin, 0, "this is not a PNG image");
}

}  // namespace

namespace {

Error damaged_png(const Reader& reader, const std::string& origin) {
    return invalid_file(origin, 0, fmt::format("damaged PNG image: {}", reader.message.text));
}

/// The pixels of a file whose header has been read, of as many bytes as its rows have.
template <class Pixel>
Image<Pixel> read_pixels(Reader& reader, const std::string& origin) {
    Image<Pixel> image(png_get_image_width(reader.png, reader.info),
                       png_get_image_height(reader.png, reader.info));
    auto* pixels = reinterpret_cast<std::uint8_t*>(image.row(0).data());
    if (!read_rows(reader, pixels, image.width() * sizeof(Pixel), image.height()))
        throw damaged_png(reader, origin);
    return image;
}

}  // namespace

Image<Rgb8> decode_png(std::span<const std::uint8_t> bytes, const std::string& origin) {
    refuse_other_formats(bytes, origin);
    Reader reader(bytes);
    if (!reader.info || !read_header(reader)) throw damaged_png(reader, origin);
    return read_pixels<Rgb8>(reader, origin);
}

PictureColors decode_png_with_alpha(std::span<const std::uint8_t> bytes,
                                    const std::string& origin) {
    refuse_other_formats(bytes, origin);
    Reader reader(bytes);
    if (!reader.info || !read_header(reader, true)) throw damaged_png(reader, origin);
    if (png_get_channels(reader.png, reader.info) == 4) return read_pixels<Rgba8>(reader, origin);
    return read_pixels<Rgb8>(reader, origin);
}

std::pair<Image<Rgb8>, Image<Grey8>> colors_and_alpha(PictureColors image) {
    if (auto* opaque = std::get_if<Image<Rgb8>>(&image))
        return {std::move(*opaque), Image<Grey8>()};
    const auto& both = std::get<Image<Rgba8>>(image);
    Image<Rgb8> colors(both.width(), both.height());
    Image<Grey8> alpha(both.width(), both.height());
    for (std::size_t y = 0; y < both.height(); ++y)
        for (std::size_t x = 0; x < both.width(); ++x) {
            const Rgba8& p = both(x, y);
            colors(x, y) = {p.r, p.g, p.b};
            alpha(x, y) = p.a;
        }
    return {std::move(colors), std::move(alpha)};
}

Image<Rgb8> read_png(const std::string& path) {
    return decode_png(read_png_bytes(path), path);
}

std::vector<std::uint8_t> read_png_bytes(const std::string& path) {
    refuse_other_formats(read_file_head(path, 8), path);
    return read_regular_file(path, most_file_bytes);
}

PngSize png_size(const std::string& path) {
    const std::vector<std::uint8_t> head = read_file_head(path, 24);
    refuse_other_formats(head, path);
    if (head.size() < 24 || std::memcmp(&head[12], "IHDR", 4) != 0)
        throw invalid_file(path, 0, "damaged PNG image: it does not begin with its size");
    return {png_get_uint_32(&head[16]), png_get_uint_32(&head[20])};
}

void write_png(const std::string& path, const Image<Rgb8>& image) {
    AtomicFile file(path);
    encode_png(image, sink_of(file));
    file.commit();
}

}  // namespace burl
