// The logarithm against the mathematical library's.
#include "atlas/base/elementary.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace burl {
namespace {

TEST(BinaryLogTest, ErrsByNoMoreThanItSays) {
    for (int i = -1074 * 7; i < 1023 * 7; ++i) {
        const double x = std::exp2(i / 7.0);
        if (!std::isnormal(x)) continue;
        const double expected = std::log2(x);
        EXPECT_NEAR(binary_log(x), expected, 1e-13 + 0x1p-52 * std::abs(expected)) << x;
    }
    EXPECT_EQ(binary_log(1.0), 0.0);
    EXPECT_EQ(binary_log(1024.0), 10.0);
}

TEST(BinaryLogTest, WhatIsNotFiniteIsLarge) {
    EXPECT_GE(binary_log(std::numeric_limits<double>::infinity()), 1024.0);
    EXPECT_GE(binary_log(std::numeric_limits<double>::quiet_NaN()), 1024.0);
}

}  // namespace
}  // namespace burl
