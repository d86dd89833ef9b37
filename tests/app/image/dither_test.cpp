// Dithering against the means of what it replaces.
#include "app/image/dither.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace burl {
namespace {

/// The mean code of red over a square.
template <class Red>
double mean_red(std::size_t x0, std::size_t y0, std::size_t side, const Red& red) {
    double sum = 0.0;
    for (std::size_t y = y0; y < y0 + side; ++y)
        for (std::size_t x = x0; x < x0 + side; ++x) sum += red(x, y);
    return sum / double(side * side);
}

TEST(Dither, KeepsTheMeanOfEveryNeighbourhood) {
    Image<Rgb8> ramp(128, 64);
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 128; ++x)
            ramp(x, y) = {std::uint8_t(41 + x), std::uint8_t(41 + x), std::uint8_t(41 + x)};
    const std::array<Rgb8, 2> palette{Rgb8{40, 40, 40}, Rgb8{180, 180, 180}};
    const Image<std::uint8_t> dots = dithered(ramp, palette);
    for (std::size_t y = 16; y + 16 <= 64; y += 16)
        for (std::size_t x = 0; x + 16 <= 128; x += 16)
            EXPECT_NEAR(
                mean_red(
                    x, y, 16,
                    [&](std::size_t i, std::size_t k) { return double(palette[dots(i, k)].r); }),
                mean_red(x, y, 16, [&](std::size_t i, std::size_t k) { return ramp(i, k).r; }), 4.0)
                << x << " " << y;
}

TEST(Dither, LeavesColorsOfThePaletteAlone) {
    Image<Rgb8> image(32, 32, Rgb8{176, 176, 176});
    for (std::size_t y = 8; y < 24; ++y)
        for (std::size_t x = 8; x < 24; ++x) image(x, y) = {std::uint8_t(60 + x), 90, 120};
    const std::array<Rgb8, 3> palette{Rgb8{40, 90, 120}, Rgb8{100, 90, 120}, Rgb8{176, 176, 176}};
    const Image<std::uint8_t> dots = dithered(image, palette);
    int first = 0, second = 0;
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 32; ++x) {
            const bool inside = x >= 8 && x < 24 && y >= 8 && y < 24;
            ASSERT_EQ(dots(x, y) == 2, !inside) << x << " " << y;
            first += dots(x, y) == 0, second += dots(x, y) == 1;
        }
    EXPECT_GT(first, 40);
    EXPECT_GT(second, 40);
}

}  // namespace
}  // namespace burl
