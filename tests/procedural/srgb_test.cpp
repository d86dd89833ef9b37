#include "procedural/srgb.h"

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

}  // namespace
}  // namespace burl
