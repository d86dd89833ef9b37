// What is kept of one map is not taken for another, nor for other pixels.
#include "procedural/color/kept_colors.h"

#include <array>

#include <gtest/gtest.h>

namespace burl {
namespace {

ColorMap ramp(std::uint8_t red) {
    ColorMap map;
    map.stops = {{0.0, {red, 0, 0}}, {1.0, {red, 255, 0}}};
    return map;
}

TEST(KeptColors, AreThoseOfTheMapAskedFor) {
    KeptColors colors;
    for (const std::uint8_t red : std::array<std::uint8_t, 4>{7, 7, 9, 7}) {
        EXPECT_EQ(colors.of<Rgb8>(ramp(red))(0.5), PointColors<Rgb8>(ramp(red))(0.5));
        EXPECT_EQ(colors.of<RgbF>(ramp(red))(0.5), PointColors<RgbF>(ramp(red))(0.5));
    }
}

}  // namespace
}  // namespace burl
