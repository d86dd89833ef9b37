// Float64 literals written as bits.
#include "app/gl/device/literals.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(ExactLiterals, BecomeTheBitsOfTheNearestNumber) {
    EXPECT_EQ(with_exact_literals("x * 3.141592653589793lf;"),
              "x * packDouble2x32(uvec2(0x54442d18u, 0x400921fbu));");
    EXPECT_EQ(with_exact_literals("1e-3lf"), "packDouble2x32(uvec2(0xd2f1a9fcu, 0x3f50624du))");
    EXPECT_EQ(with_exact_literals(".1lf"), "packDouble2x32(uvec2(0x9999999au, 0x3fb99999u))");
    EXPECT_EQ(with_exact_literals("-.1LF;"), "-packDouble2x32(uvec2(0x9999999au, 0x3fb99999u));");
}

TEST(ExactLiterals, LeaveAllElse) {
    for (const char* text : {"", "0.5lf", "1.0lf / 6755399441055744.0lf", "0.1", "a0.1lf", "0.1lfx",
                             "table0.x", "0x1fu", "12"})
        EXPECT_EQ(with_exact_literals(text), text);
}

}  // namespace
}  // namespace burl
