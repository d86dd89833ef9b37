// What the numbers rely on and a compiler may take away. g++ 12.2 at -O2 turns the pair of
// conversions double -> float -> double into none when its block vectorizer packs two of them:
// differences between a double and its rounding, which carry a coordinate's low bits, become zero.
// Nothing may be known of the arguments (noipa): with constants the compiler works the answer out
// itself.
#include <gtest/gtest.h>

#include "atlas/base/vec.h"

namespace burl {
namespace {

[[gnu::noipa]] Vec3d through_float(const Vec3d& v) {
    return Vec3d(Vec3f(v));
}

[[gnu::noipa]] Vec2d lost_by_float(const Vec2d& v) {
    const auto x = static_cast<float>(v.x), y = static_cast<float>(v.y);
    return {v.x - static_cast<double>(x), v.y - static_cast<double>(y)};
}

[[gnu::noipa]] double product_and_sum(double a, double b, double c) {
    return a * b + c;
}

TEST(Compiler, KeepsRoundingToFloat) {
    const double tenth_as_float = 13421773.0 / 134217728.0;  // 0.1 to 24 bits
    EXPECT_EQ(through_float(Vec3d(0.1)), Vec3d(tenth_as_float));
    EXPECT_EQ(lost_by_float(Vec2d(0.1)), Vec2d(0.1 - tenth_as_float));
}

TEST(Compiler, DoesNotFuseProductsIntoSums) {
    const double square = 0.1 * 0.1;
    EXPECT_EQ(product_and_sum(0.1, 0.1, -square), 0.0);  // fused: -8.3e-19
}

}  // namespace
}  // namespace burl
