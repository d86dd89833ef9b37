#include "procedural/color/srgb.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(Srgb, HasTheStandardsValues) {
    EXPECT_EQ(srgb_decode(0.0), 0.0);
    EXPECT_EQ(srgb_decode(1.0), 1.0);
    EXPECT_NEAR(srgb_decode(0.5), 0.21404114048223255, 1e-15);
    EXPECT_NEAR(srgb_encode(0.18), 0.46135612950044164, 1e-15);
    // The two pieces meet, as far as the standard's rounded constants let them.
    EXPECT_NEAR(srgb_decode(0.04045), srgb_decode(std::nextafter(0.04045, 1.0)), 1e-8);
}

template <class Code>
void check_every_code() {
    const SrgbEncoder<Code> encode;
    constexpr std::uint32_t max = std::numeric_limits<Code>::max();
    for (std::uint32_t code = 0; code <= max; ++code) {
        ASSERT_EQ(encode(srgb_decode(double(code) / max)), code);
        if (code == max) break;
        // Just on either side of the place where the exact formula rounds to the next code.
        const double threshold = srgb_decode((code + 0.5) / max);
        for (const double side : {1.0 - 1e-12, 1.0 + 1e-12}) {
            const double linear = threshold * side;
            ASSERT_EQ(encode(linear), std::lround(srgb_encode(linear) * max))
                << "code " << code << " side " << side - 1.0;
        }
    }
    EXPECT_EQ(encode(-1.0), 0u);
    EXPECT_EQ(encode(2.0), max);
    EXPECT_EQ(encode(std::numeric_limits<double>::quiet_NaN()), 0u);
    EXPECT_EQ(encode(std::numeric_limits<double>::infinity()), max);
}

TEST(SrgbEncoder, RoundsEvery8BitCodeAsTheFormula) {
    check_every_code<std::uint8_t>();
}
TEST(SrgbEncoder, RoundsEvery16BitCodeAsTheFormula) {
    check_every_code<std::uint16_t>();
}

TEST(SrgbEncoder, AgreesWithTheFormulaOnAFineRamp) {
    const SrgbEncoder<std::uint8_t> encode;
    for (int i = 0; i <= 200000; ++i) {
        const double linear = i / 200000.0;
        ASSERT_EQ(encode(linear), std::lround(255.0 * srgb_encode(linear))) << linear;
    }
}

TEST(SrgbStreamEncoder, HasTheEncodersCodes) {
    const SrgbEncoder<std::uint8_t> encode;
    std::vector<double> values{-1.0,   2.0,  0.0,          1.0,
                               5e-324, -0.0, std::nan(""), std::numeric_limits<double>::infinity()};
    for (int i = 0; i < 256; ++i)
        for (const double side : {1.0 - 1e-15, 1.0, 1.0 + 1e-15})
            values.push_back(srgb_decode((i + 0.5) / 255.0) * side);
    for (int bucket = 0; bucket <= 512; ++bucket)  // where the stream's encoder splits [0,1]
        for (const double side : {1.0 - 1e-7, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 1.0 + 1e-7})
            values.push_back(bucket / 512.0 * bucket / 512.0 * side);
    alignas(64) double linear[64 + 16] = {};
    alignas(64) std::uint8_t codes[64 + 16];
    const SrgbStreamEncoder stream;
    for (std::size_t begin = 0; begin < values.size(); begin += 64) {
        const std::size_t count = std::min<std::size_t>(64, values.size() - begin);
        std::copy_n(values.begin() + std::ptrdiff_t(begin), count, linear);
        stream(linear, count, codes);
        for (std::size_t i = 0; i < count; ++i)
            EXPECT_EQ(codes[i], encode(values[begin + i])) << values[begin + i];
    }
}

}  // namespace
}  // namespace burl
