#include "procedural/color/map.h"

#include <random>

#include <gtest/gtest.h>

#include "procedural/color/srgb.h"
#include "procedural/color/table.h"
#include "procedural/model/texture.h"

namespace burl {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// Red channel only, as an sRGB code.
ColorMap reds(Wrap wrap, std::vector<std::pair<double, std::uint8_t>> stops) {
    ColorMap map{wrap, {}};
    for (const auto& [position, red] : stops) map.stops.push_back({position, {red, 0, 0}});
    return map;
}

double linear(int code) {
    return srgb_decode(code / 255.0);
}

void expect_red(const ColorMap& map, double f, double expected) {
    EXPECT_NEAR(evaluate_color(map, f).r, expected, 1e-14) << "f = " << f;
    EXPECT_NEAR(PreparedColorMap(map)(f).r, expected, 1e-14) << "f = " << f;
}

TEST(ColorMap, InterpolatesInLinearLight) {
    const ColorMap map = reds(Wrap::clamp, {{0.0, 0}, {1.0, 255}});
    expect_red(map, 0.25, 0.25);
    expect_red(map, 0.5, 0.5);
    // Half the light is code 188, not 128.
    EXPECT_EQ(ColorTable8(map)(0.5).r, 188);
}

TEST(ColorMap, ClampGoesOnWithTheEndColours) {
    const ColorMap map = reds(Wrap::clamp, {{0.25, 50}, {0.75, 200}});
    for (const double f : {-inf, -3.0, 0.0, 0.2, 0.25}) expect_red(map, f, linear(50));
    for (const double f : {0.75, 0.9, 1.0, 7.5, inf}) expect_red(map, f, linear(200));
    expect_red(map, 0.5, 0.5 * (linear(50) + linear(200)));
    expect_red(map, nan, linear(50));
}

TEST(ColorMap, RepeatTakesTheIndexModuloOne) {
    const ColorMap map = reds(Wrap::repeat, {{0.0, 0}, {1.0, 255}});
    for (const double f : {0.0, 1.0, 2.0, -1.0, nan, inf, -inf, -1e-20}) expect_red(map, f, 0.0);
    for (const double f : {0.25, 1.25, -0.75, 1000.25}) expect_red(map, f, 0.25);
    EXPECT_NEAR(evaluate_color(map, std::nextafter(1.0, 0.0)).r, 1.0, 1e-14);
}

TEST(ColorMap, RepeatInterpolatesAcrossTheWrap) {
    const ColorMap map = reds(Wrap::repeat, {{0.2, 0}, {0.7, 255}});
    // From 0.7 (white) to 1.2 (black).
    expect_red(map, 0.7, 1.0);
    expect_red(map, 0.95, 0.5);
    expect_red(map, 0.0, 0.4);
    expect_red(map, 0.1, 0.2);
    expect_red(map, 0.2, 0.0);
    expect_red(map, -0.05, 0.5);
}

TEST(ColorMap, EqualPositionsJumpAndBelongToTheRight) {
    const ColorMap map =
        reds(Wrap::clamp, {{0.0, 10}, {0.5, 20}, {0.5, 99}, {0.5, 180}, {1.0, 200}});
    expect_red(map, 0.5, linear(180));
    EXPECT_NEAR(evaluate_color(map, std::nextafter(0.5, 0.0)).r, linear(20), 1e-14);
    EXPECT_NEAR(PreparedColorMap(map)(std::nextafter(0.5, 0.0)).r, linear(20), 1e-14);
    const ColorMap ends = reds(Wrap::clamp, {{0.0, 1}, {0.0, 30}, {1.0, 40}, {1.0, 250}});
    expect_red(ends, 0.0, linear(30));
    expect_red(ends, -1.0, linear(30));
    expect_red(ends, 1.0, linear(250));
}

TEST(ColorMap, StopsAFloatApartHaveTheirColours) {
    const double below_one = std::nextafter(1.0, 0.0);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        const ColorMap map{wrap,
                           {{0.0, {10, 20, 30}},
                            {5e-324, {90, 80, 70}},
                            {1e-310, {1, 2, 3}},
                            {1e-17, {200, 100, 0}},
                            {below_one, {0, 0, 99}},
                            {1.0, {255, 0, 0}}}};
        const PreparedColorMap prepared(map);
        const ColorTable8 table(map);
        for (const ColorStop& stop : map.stops) {
            if (wrap == Wrap::repeat && stop.position == 1.0) continue;  // index 0
            const double f = stop.position;
            EXPECT_NEAR(glm::distance(prepared(f), linear_light(stop.color)), 0.0, 1e-14) << f;
            EXPECT_NEAR(glm::distance(evaluate_color(map, f), prepared(f)), 0.0, 1e-14) << f;
            EXPECT_EQ(table(f), stop.color) << f;
        }
    }
}

TEST(ColorMap, OneStopIsAConstant) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
        for (const double f : {-0.3, 0.0, 0.4, 0.6, 1.0, 3.2})
            expect_red(reds(wrap, {{0.4, 77}}), f, linear(77));
}

ColorMap random_map(std::mt19937& random) {
    ColorMap map;
    map.wrap = random() % 2 ? Wrap::repeat : Wrap::clamp;
    std::vector<double> positions(1 + random() % 6);
    for (double& p : positions) p = double(random() % 9) / 8.0;
    if (random() % 2)
        for (double& p : positions) p = std::min(1.0, p + 1e-5 * double(random() % 1000));
    std::sort(positions.begin(), positions.end());
    for (const double p : positions)
        map.stops.push_back(
            {p, {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random())}});
    return map;
}

TEST(ColorTable8, IsTheReferenceRounded) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> anywhere(-3.0, 3.0);
    for (int i = 0; i < 40; ++i) {
        const ColorMap map = random_map(random);
        const ColorTable8 table(map);
        const auto check = [&](double f) {
            const Vec3d exact = 255.0 * Vec3d(srgb_encode(evaluate_color(map, f).r),
                                              srgb_encode(evaluate_color(map, f).g),
                                              srgb_encode(evaluate_color(map, f).b));
            const Rgb8 code = table(f);
            ASSERT_LE(std::abs(code.r - exact.r), 0.5 + 1e-9) << f;
            ASSERT_LE(std::abs(code.g - exact.g), 0.5 + 1e-9) << f;
            ASSERT_LE(std::abs(code.b - exact.b), 0.5 + 1e-9) << f;
        };
        for (int j = 0; j < 2000; ++j) check(anywhere(random));
        for (const ColorStop& stop : map.stops)
            for (const double f : {stop.position, std::nextafter(stop.position, -1.0)}) check(f);
        for (const double f : {1e300, -1e300, inf, -inf, nan, -1e-20, -0.0}) check(f);
    }
}

}  // namespace
}  // namespace burl
