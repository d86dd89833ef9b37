// Codes looked up by f's place against the list of steps gone through one by one, on every
// instruction set.
#include "procedural/color/table.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "procedural/batch/texel_batch.h"
#include "tests/procedural/support/only_target.h"

namespace burl {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ColorMap color_table_random_map(std::mt19937& random) {
    ColorMap map;
    map.wrap = random() % 2 ? Wrap::repeat : Wrap::clamp;
    std::vector<double> positions(1 + random() % 6);
    for (double& p : positions) p = double(random() % 100000) / 99999.0;
    if (random() % 3 == 0) positions.push_back(positions.front());  // a jump
    std::ranges::sort(positions);
    for (const double p : positions) {
        const auto bits = std::uint32_t(random());
        map.stops.push_back(
            {p, {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16)}});
    }
    return map;
}

/// All over the map, and at its steps, beside them by one rounding and by less than a place.
std::vector<double> values_around(const ColorTable8& table, std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(-3.0, 4.0);
    std::vector<double> f = {0.0,
                             -0.0,
                             1.0,
                             -1e-20,
                             1e300,
                             infinity,
                             -1e300,
                             -infinity,
                             -0.3,
                             std::numeric_limits<double>::quiet_NaN(),
                             std::nextafter(1.0, 0.0)};
    for (const ColorTable8::Step& step : table.steps()) {
        if (!(step.index <= 1.0)) continue;
        const double place = 1.0 / ColorTable8::places;
        const double part = 0x1p-18;
        for (const double x :
             {step.index, std::nextafter(step.index, -1.0), std::nextafter(step.index, 2.0),
              step.index - 0.4 * place, step.index + 0.4 * place, step.index - place,
              std::floor(step.index / part) * part, std::ceil(step.index / part) * part})
            f.push_back(x);
    }
    std::ranges::shuffle(f, random);
    while (f.size() < 100) f.push_back(anywhere(random));
    f.resize(std::min(f.size(), batch_capacity - random() % 30));
    return f;
}

Rgb8 color_by_steps(const ColorTable8& table, double f) {
    const double t = map_index(table.wrap(), f);
    Rgb8 color;
    for (const ColorTable8::Step& step : table.steps())
        if (step.index <= t) color = step.color;
    return color;
}

TEST(ColorTable8, LooksUpTheLastStepUpToEveryPlaceHoweverNear) {
    std::mt19937 random(1);
    alignas(64) static std::int32_t places[batch_capacity + batch_padding];
    alignas(64) static ColorCode codes[batch_capacity + batch_padding];
    static std::uint32_t later[batch_capacity + 2 * batch_padding];
    for (int i = 0; i < 60; ++i) {
        const ColorMap map = color_table_random_map(random);
        const ColorTable8 table(map);
        std::vector<double> f = values_around(table, random);
        const std::size_t count = f.size();
        f.resize(count + batch_padding);
        on_every_target([&] {
            index_colors(map.wrap, f.data(), count, ColorTable8::places, places);
            table.look_up(places, f.data(), count, codes, later);
            for (std::size_t j = 0; j < count; ++j)
                ASSERT_EQ(codes[j].color, color_by_steps(table, f[j])) << i << " " << f[j];
        });
        for (const double x : f) ASSERT_EQ(table(x), color_by_steps(table, x)) << i << " " << x;
    }
}

}  // namespace
}  // namespace burl
