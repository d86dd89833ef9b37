#pragma once
// PNG files as libpng's plain interface reads them, without conversions.
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <png.h>

namespace burl {

/// A file's codes as they stand in it.
struct RawPng {
    png_uint_32 width = 0, height = 0;
    int bits = 0, color_type = 0;
    bool srgb = false;
    std::vector<std::uint16_t> codes;  ///< all channels of all pixels, row by row
};

inline RawPng raw_png(std::vector<std::uint8_t> bytes) {
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    auto rest = std::span<const std::uint8_t>(bytes);
    png_set_read_fn(png, &rest, [](png_structp p, png_bytep out, std::size_t n) {
        auto* from = static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(p));
        std::copy_n(from->begin(), n, out);
        *from = from->subspan(n);
    });
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    int intent = 0;
    RawPng result{png_get_image_width(png, info),        png_get_image_height(png, info),
                  png_get_bit_depth(png, info),          png_get_color_type(png, info),
                  png_get_sRGB(png, info, &intent) != 0, {}};
    png_bytepp rows = png_get_rows(png, info);
    const std::size_t step = std::size_t(result.bits / 8);
    for (png_uint_32 y = 0; y < result.height; ++y)
        for (std::size_t i = 0; i < png_get_rowbytes(png, info); i += step)
            result.codes.push_back(step == 1 ? rows[y][i]
                                             : std::uint16_t(rows[y][i] << 8 | rows[y][i + 1]));
    png_destroy_read_struct(&png, &info, nullptr);
    return result;
}

}  // namespace burl
