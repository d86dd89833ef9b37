// Sine, angle and power of single numbers: the vectors' bits, and the C library's to 1e-13.
#include "atlas/base/elementary.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "procedural/graph/value_kernels.h"

namespace burl {
namespace {

constexpr std::size_t count = 256;

/// Numbers of all sizes and signs, zeros and powers of two among them.
struct Numbers {
    alignas(64) double a[count + batch_padding] = {};
    alignas(64) double b[count + batch_padding] = {};
    alignas(64) double out[count + batch_padding] = {};

    Numbers() {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        for (std::size_t j = 0; j < count; ++j) {
            a[j] = std::ldexp(uniform(random), int(j % 16) - 4);
            b[j] = std::ldexp(uniform(random), int(j / 16) - 4);
        }
        a[0] = b[0] = 0.0, a[1] = 0.0, b[2] = 0.0, a[3] = 1.0, b[3] = -1.0;
    }
    const double* kernel(const ValueOperation& operation) {
        apply(operation, {a, b, nullptr, nullptr}, count, out);
        return out;
    }
};

TEST(Elementary, SineIsTheVectors) {
    Numbers numbers;
    numbers.kernel({ValueOp::sine, {}});
    for (std::size_t j = 0; j < count; ++j) {
        const double x = numbers.a[j];
        EXPECT_EQ(sine(x), numbers.out[j]) << x;
        EXPECT_NEAR(sine(x), std::sin(x), 1e-13 + std::ldexp(std::abs(x), -50)) << x;
        EXPECT_NEAR(cosine(x), std::cos(x), 1e-13 + std::ldexp(std::abs(x), -49)) << x;
    }
    EXPECT_EQ(sine(0x1p50), 0.0);
}

TEST(Elementary, AnglesAreTheVectors) {
    Numbers numbers;
    numbers.kernel({ValueOp::angle, {}});
    for (std::size_t j = 0; j < count; ++j) {
        const double y = numbers.a[j], x = numbers.b[j];
        EXPECT_EQ(angle_of(y, x), numbers.out[j]) << y << " " << x;
        EXPECT_NEAR(angle_of(y, x), std::atan2(y, x), 1e-13) << y << " " << x;
    }
    EXPECT_NEAR(angle_of(-0.0, -1.0), std::numbers::pi, 1e-13);  // in (-pi, pi]
}

TEST(Elementary, PowersAreTheVectors) {
    Numbers numbers;
    for (const double e : {0.5, 1.0, 2.0, 2.5, 7.0, 63.5}) {
        numbers.kernel({ValueOp::power, {e}});
        for (std::size_t j = 0; j < count; ++j) {
            const double x = numbers.a[j], expected = std::pow(x, e);
            EXPECT_EQ(power(x, e), numbers.out[j]) << x << "^" << e;
            if (x <= 0.0) continue;
            const double relative = 1e-13 * (1.0 + std::abs(e * std::log2(x)));
            EXPECT_NEAR(power(x, e), expected, relative * expected) << x << "^" << e;
        }
    }
    EXPECT_NEAR(power(3.0, -0.5), std::pow(3.0, -0.5), 1e-12);
    EXPECT_EQ(power(0.0, -0.5), 0.0);
    EXPECT_EQ(power(-2.0, 3.0), -8.0);
    EXPECT_EQ(power(-2.0, 0.5), 0.0);
}

TEST(Elementary, PowersOfTwoEndInZeroAndInfinity) {
    EXPECT_EQ(binary_power(10.0), 1024.0);
    EXPECT_EQ(binary_power(-1022.0), 0x1p-1022);
    EXPECT_EQ(binary_power(-1023.0), 0.0);
    EXPECT_TRUE(std::isinf(binary_power(1023.5)));
}

}  // namespace
}  // namespace burl
