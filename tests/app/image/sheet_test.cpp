// Sheets of pictures, pixel by pixel.
#include "app/image/sheet.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

Image<Rgb8> flat(std::uint8_t red, std::size_t width = 64, std::size_t height = 20) {
    Image<Rgb8> image(width, height, Rgb8{red, 100, 100});
    image(0, 0) = {176, 176, 176};
    return image;
}

TEST(Sheet, HasAboutAsManyRowsAsColumnsUnlessToldOtherwise) {
    const auto grid = [](std::size_t count, std::size_t columns) {
        const SheetGrid result = sheet_grid(count, columns, {64, 20});
        return std::pair(int(result.columns), int(result.rows));
    };
    EXPECT_EQ(grid(1, 0), std::pair(1, 1));
    EXPECT_EQ(grid(5, 0), std::pair(3, 2));
    EXPECT_EQ(grid(9, 0), std::pair(3, 3));
    EXPECT_EQ(grid(9, 4), std::pair(4, 3));
    EXPECT_EQ(grid(3, 8), std::pair(3, 1));
}

TEST(Sheet, PutsPicturesInOrderWithTheirNamesBelow) {
    const std::vector<Picture> pictures{flat(1), flat(2), flat(3)};
    const std::vector<std::string> names{"il", "", "a-name-that-is-too-long"};
    const SheetGrid grid = sheet_grid(3, 2, {64, 20});
    const auto sheet = std::get<Image<Rgb8>>(sheet_of(pictures, names, grid));
    ASSERT_EQ(sheet.width(), 128u);
    ASSERT_EQ(sheet.height(), 2 * grid.cell_height);
    const auto dots_in = [&](std::size_t column, std::size_t row) {
        int dots = 0;
        for (std::size_t y = row * grid.cell_height + 20; y < (row + 1) * grid.cell_height; ++y)
            for (std::size_t x = 64 * column; x < 64 * (column + 1); ++x)
                dots += sheet(x, y) != Rgb8{176, 176, 176};
        return dots;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t left = 64 * (i % 2), top = i / 2 * grid.cell_height;
        EXPECT_EQ(sheet(left + 1, top), (Rgb8{std::uint8_t(i + 1), 100, 100}));
        EXPECT_EQ(sheet(left + 63, top + 19), (Rgb8{std::uint8_t(i + 1), 100, 100}));
    }
    EXPECT_GT(dots_in(0, 0), 10);
    EXPECT_EQ(dots_in(1, 0), 0);
    EXPECT_GT(dots_in(0, 1), 80);
    EXPECT_EQ(dots_in(1, 1), 0);
}

TEST(Sheet, WritesLettersUpright) {
    // An L has its foot at the bottom right, a T its bar on top.
    const SheetGrid grid = sheet_grid(1, 1, {8, 8});
    const auto row_of = [&](const char* name, std::size_t dots_from_top) {
        const auto sheet = std::get<Image<Rgb8>>(sheet_of({Image<Rgb8>(8, 8)}, {name}, grid));
        int dots = 0;
        for (std::size_t x = 0; x < 8; ++x) dots += sheet(x, 8 + dots_from_top) != Rgb8{};
        return dots;
    };
    EXPECT_GT(row_of("L", 6), row_of("L", 1));
    EXPECT_GT(row_of("T", 0), row_of("T", 5));
}

TEST(Sheet, KeepsAlpha) {
    const Picture clear = Image<Rgba8>(32, 8);
    const auto sheet =
        std::get<Image<Rgba8>>(sheet_of({clear, clear}, {"a", "b"}, sheet_grid(2, 2, {32, 8})));
    int opaque_dots = 0;
    for (const Rgba8& p : sheet.pixels()) opaque_dots += p.a == 255;
    EXPECT_GT(opaque_dots, 10);
    EXPECT_EQ(sheet(0, 0).a, 0);
}

}  // namespace
}  // namespace burl
