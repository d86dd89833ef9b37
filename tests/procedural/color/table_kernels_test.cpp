// Codes from tables and pixels from codes against loops over single texels.
#include "procedural/color/table.h"

#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "procedural/batch/texel_batch.h"

namespace burl {
namespace {

std::vector<ColorCode> random_table(std::mt19937& random, std::size_t size) {
    std::vector<ColorCode> table(size);
    for (ColorCode& code : table) {
        const auto bits = std::uint32_t(random());
        code = {{std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16)},
                bits >> 24 > 40};
    }
    return table;
}

TEST(ColorKernels, IndexColorsAsTheMapDoes) {
    std::mt19937 random(1);
    std::vector<double> f{0.0,
                          1.0,
                          -1.0,
                          0.5,
                          -0.25,
                          2.75,
                          -1e-20,
                          1e300,
                          -1e300,
                          1e15,
                          -1e15,
                          0.9999999999999999,
                          std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(),
                          std::numeric_limits<double>::quiet_NaN()};
    std::uniform_real_distribution<double> anywhere(-4.0, 4.0);
    while (f.size() < 200) f.push_back(anywhere(random));
    const std::size_t count = f.size();
    f.resize(count + batch_padding);
    std::vector<std::int32_t> entries(count + batch_padding);
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
        index_colors(wrap, f.data(), count, 1000, entries.data());
        for (std::size_t j = 0; j < count; ++j)
            EXPECT_EQ(entries[j], std::int32_t(map_index(wrap, f[j]) * 1000.0)) << f[j];
    }
}

TEST(ColorKernels, LookUpCodesAndTellTheUnfinished) {
    std::mt19937 random(1);
    const std::vector<ColorCode> table = random_table(random, 5000);
    alignas(64) static std::int32_t places[batch_capacity + batch_padding];
    alignas(64) static ColorCode codes[batch_capacity + batch_padding];
    static std::uint32_t later[batch_capacity + 2 * batch_padding];
    for (std::int32_t& place : places)
        place = std::int32_t(random() % (table.size() << place_bits));
    for (const std::size_t count : {0, 1, 7, 8, 15, 16, 17, 100, 1023, 1024}) {
        const std::size_t found = look_up_codes(table.data(), places, count, codes, later);
        std::vector<std::uint32_t> expected;
        for (std::size_t j = 0; j < count; ++j) {
            const ColorCode& code = table[std::size_t(places[j] >> place_bits)];
            if (!code.uniform) expected.push_back(std::uint32_t(j));
            ASSERT_EQ(codes[j].color, code.color) << count << " " << j;
        }
        ASSERT_EQ(std::vector(later, later + found), expected) << count;
    }
}

TEST(ColorKernels, PackPixelsAndNothingBeyond) {
    std::mt19937 random(2);
    const std::vector<ColorCode> codes = random_table(random, 64);
    const Rgb8 untouched{1, 2, 3};
    for (std::size_t count = 0; count <= 40; ++count) {
        std::vector<Rgb8> pixels(count + 8, untouched);
        pack_pixels(codes.data(), count, pixels.data());
        for (std::size_t j = 0; j < pixels.size(); ++j)
            ASSERT_EQ(pixels[j], j < count ? codes[j].color : untouched) << count << " " << j;
    }
}

}  // namespace
}  // namespace burl
