#include "app/image/sheet.h"

#include <algorithm>
#include <cmath>

#include <gif_lib.h>

namespace burl {

namespace {

constexpr std::size_t glyph_side = GIF_FONT_WIDTH;  // letters of 8 x 8 dots
constexpr std::size_t glyphs = 128;

/// The height in pixels of a name below its picture: its letters, and half of them for air.
std::size_t text_height(std::size_t scale) {
    return scale * glyph_side * 3 / 2;
}

/// Whether giflib's font has a dot at column x and row y of a letter.
bool has_dot(unsigned char letter, std::size_t x, std::size_t y) {
    if (letter >= glyphs) letter = '?';
    return (GifAsciiTable8x8[letter][y] >> (glyph_side - 1 - x)) & 1;
}

/// Black or white, whichever is farther from the colour.
template <class Pixel>
Pixel text_color(const Pixel& behind) {
    const int luminance = (2126 * behind.r + 7152 * behind.g + 722 * behind.b) / 10000;
    Pixel color = behind;
    color.r = color.g = color.b = luminance < 100 ? 235 : 24;
    if constexpr (requires { color.a; }) color.a = 255;
    return color;
}

/// Writes a name into the cell with its corner at (left, top), centred below its picture.
template <class Pixel>
void write_name(Image<Pixel>& sheet, const std::string& name, const SheetGrid& grid,
                std::size_t left, std::size_t top) {
    const std::size_t letter = grid.text_scale * glyph_side;
    const std::size_t count = std::min(name.size(), grid.cell_width / letter);
    const std::size_t x0 = left + (grid.cell_width - count * letter) / 2;
    const std::size_t y0 = top + grid.cell_height - text_height(grid.text_scale);
    const Pixel color = text_color(sheet(left, y0));
    for (std::size_t y = 0; y < letter; ++y)
        for (std::size_t x = 0; x < count * letter; ++x)
            if (has_dot(static_cast<unsigned char>(name[x / letter]), x % letter / grid.text_scale,
                        y / grid.text_scale))
                sheet(x0 + x, y0 + y) = color;
}

template <class Pixel>
Image<Pixel> composed(const std::vector<Picture>& pictures, const std::vector<std::string>& names,
                      const SheetGrid& grid) {
    const auto& first = std::get<Image<Pixel>>(pictures.front());
    Image<Pixel> sheet(grid.size().width, grid.size().height, first(0, 0));
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const auto& picture = std::get<Image<Pixel>>(pictures[i]);
        const std::size_t left = i % grid.columns * grid.cell_width;
        const std::size_t top = i / grid.columns * grid.cell_height;
        for (std::size_t y = 0; y < picture.height(); ++y)
            std::ranges::copy(picture.row(y), sheet.row(top + y).subspan(left).begin());
        write_name(sheet, names[i], grid, left, top);
    }
    return sheet;
}

}  // namespace

SheetGrid sheet_grid(std::size_t count, std::size_t columns, const PngSize& picture) {
    SheetGrid grid;
    const auto square = std::size_t(std::ceil(std::sqrt(double(count))));
    grid.columns = std::min(count, columns > 0 ? columns : square);
    grid.rows = (count + grid.columns - 1) / grid.columns;
    grid.text_scale = std::max<std::size_t>(1, picture.width / 300);
    grid.cell_width = picture.width;
    grid.cell_height = picture.height + text_height(grid.text_scale);
    return grid;
}

Picture sheet_of(const std::vector<Picture>& pictures, const std::vector<std::string>& names,
                 const SheetGrid& grid) {
    if (has_alpha(pictures.front())) return composed<Rgba8>(pictures, names, grid);
    return composed<Rgb8>(pictures, names, grid);
}

}  // namespace burl
