#include "procedural/graph/value_kernels.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "procedural/graph/value_program.h"
#include "procedural/numbers/simd_target.h"
#include "tests/procedural/support/only_target.h"

namespace burl {
namespace {

using Array = ValueProgram::Scratch::Array;

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// The operation of up to four numbers.
double operation_value(ValueOp op, std::array<double, 4> inputs,
                       std::array<double, 4> parameters = {}) {
    Array arrays[5];
    for (std::size_t k = 0; k < 4; ++k) arrays[k].values[0] = inputs[k];
    apply({op, parameters},
          {arrays[0].values, arrays[1].values, arrays[2].values, arrays[3].values}, 1,
          arrays[4].values);
    return arrays[4].values[0];
}

TEST(ValueKernels, ArithmeticIsThatOfFloat64) {
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        const double a = uniform(random, -3, 3), b = uniform(random, -3, 3),
                     c = uniform(random, -3, 3), d = uniform(random, -3, 3);
        const double p = uniform(random, -3, 3), q = uniform(random, -3, 3),
                     r = uniform(random, -3, 3), s = uniform(random, -3, 3);
        const auto get = [&](ValueOp op) {
            return operation_value(op, {a, b, c, d}, {p, q, r, s});
        };
        EXPECT_EQ(get(ValueOp::constant), p);
        EXPECT_EQ(get(ValueOp::affine), p * a + q * b + r * c + s);
        EXPECT_EQ(get(ValueOp::linear), p * a + q);
        EXPECT_EQ(get(ValueOp::combine), p * a + q * b + r);
        EXPECT_EQ(get(ValueOp::add), a + b);
        EXPECT_EQ(get(ValueOp::multiply), a * b);
        EXPECT_EQ(get(ValueOp::products), a * b + c * d);
        EXPECT_EQ(get(ValueOp::ratio), b > 0.0 ? a / b : 0.0);
        EXPECT_EQ(get(ValueOp::minimum), std::min(a, b));
        EXPECT_EQ(get(ValueOp::maximum), std::max(a, b));
        EXPECT_EQ(get(ValueOp::absolute), std::abs(a));
        EXPECT_EQ(get(ValueOp::floor), std::floor(a));
        EXPECT_EQ(get(ValueOp::fract), a - std::floor(a));
        EXPECT_EQ(get(ValueOp::odd), std::int64_t(std::floor(a)) % 2 != 0 ? 1.0 : 0.0);
        EXPECT_EQ(get(ValueOp::at_least), a >= p ? 1.0 : 0.0);
        EXPECT_EQ(get(ValueOp::lerp), (1.0 - a) * b + a * c);
        EXPECT_NEAR(get(ValueOp::length), std::hypot(a, b), 1e-15);
        EXPECT_NEAR(get(ValueOp::smoothstep), dual_smoothstep(p, q, a).value, 1e-15);
    }
    EXPECT_EQ(operation_value(ValueOp::smoothstep, {2.0}, {2.0, 2.0}), 1.0);
    EXPECT_EQ(operation_value(ValueOp::smoothstep, {1.9}, {2.0, 2.0}), 0.0);
    EXPECT_EQ(operation_value(ValueOp::odd, {-1.0}), 1.0);
    EXPECT_EQ(operation_value(ValueOp::odd, {1e300}), 0.0);
}

TEST(ValueKernels, SinesErrByLittle) {
    std::mt19937 random(2);
    double near = 0.0, far = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const double x = uniform(random, -10, 10);
        near = std::max(near, std::abs(operation_value(ValueOp::sine, {x}) - std::sin(x)));
        const double y = std::ldexp(uniform(random, -1, 1), int(random() % 49));
        const double error = std::abs(operation_value(ValueOp::sine, {y}) - std::sin(y));
        far = std::max(far, error / (1e-13 + 0x1p-50 * std::abs(y)));
    }
    EXPECT_LT(near, 1e-13);
    EXPECT_LT(far, 1.0);
    constexpr double quarters[] = {0.0, 1.0, 0.0, -1.0};
    for (int n = -9; n <= 9; ++n)
        EXPECT_NEAR(operation_value(ValueOp::sine, {n * std::numbers::pi / 2}), quarters[n & 3],
                    1e-13);
    EXPECT_EQ(operation_value(ValueOp::sine, {1e300}), 0.0);
}

TEST(ValueKernels, AnglesErrByLittle) {
    std::mt19937 random(3);
    for (int i = 0; i < 200000; ++i) {
        const double size = std::ldexp(1.0, int(random() % 80) - 40);
        const double y = uniform(random, -1, 1), x = size * uniform(random, -1, 1);
        ASSERT_NEAR(operation_value(ValueOp::angle, {y, x}), std::atan2(y, x), 1e-13)
            << y << " " << x;
    }
    for (const double y : {-2.0, -0.0, 0.0, 2.0})
        for (const double x : {-2.0, 2.0})
            EXPECT_NEAR(operation_value(ValueOp::angle, {y, x}), std::atan2(y, x), 1e-15);
    EXPECT_EQ(operation_value(ValueOp::angle, {0.0, 0.0}), 0.0);
    EXPECT_NEAR(operation_value(ValueOp::angle, {1.0, 0.0}), std::numbers::pi / 2, 1e-15);
}

TEST(ValueKernels, PowersErrByLittle) {
    std::mt19937 random(4);
    for (int i = 0; i < 100000; ++i) {
        const double x = std::ldexp(uniform(random, 0.5, 1), int(random() % 24) - 12);
        const double e = uniform(random, 0, 64), whole = double(random() % 65);
        const double exact = std::pow(x, e);
        const double allowed = 1e-13 * (1.0 + std::abs(e * std::log2(x)));
        ASSERT_NEAR(operation_value(ValueOp::power, {x}, {e}) / exact, 1.0, allowed)
            << x << " " << e;
        ASSERT_NEAR(operation_value(ValueOp::power, {-x}, {whole}) / std::pow(-x, whole), 1.0,
                    allowed);
    }
    EXPECT_EQ(operation_value(ValueOp::power, {-1.0}, {0.5}), 0.0);
    EXPECT_EQ(operation_value(ValueOp::power, {0.0}, {0.5}), 0.0);
    EXPECT_EQ(operation_value(ValueOp::power, {0.0}, {0.0}), 1.0);
    EXPECT_EQ(operation_value(ValueOp::power, {1e300}, {2.5}),
              std::numeric_limits<double>::infinity());
}

TEST(ValueKernels, PiecesAreTheMap) {
    // A jump at 1/2 and a slope that goes on to the left of 0.
    ColorPieces pieces;
    pieces.begins = {0.0, 0.5};
    pieces.table = {0.0, 1, 2, 3, 4, 5, 6, 0.5, 7, 0, 8, 0, 9, -2};
    std::mt19937 random(5);
    for (const auto argument : {ColorPieces::Argument::clamp, ColorPieces::Argument::repeat}) {
        pieces.argument = argument;
        Array x, r, g, b;
        for (double& v : x.values) v = uniform(random, -2, 3);
        x.values[0] = 0.5, x.values[1] = std::numeric_limits<double>::infinity();
        x.values[2] = std::numeric_limits<double>::quiet_NaN();
        look_up(pieces, x.values, value_batch, {r.values, g.values, b.values});
        for (std::size_t j = 0; j < value_batch; ++j) {
            const double f = std::isfinite(x.values[j]) ? x.values[j] : 0.0;
            const double t = argument == ColorPieces::Argument::clamp ? std::clamp(f, 0.0, 1.0)
                                                                      : f - std::floor(f);
            EXPECT_NEAR(r.values[j], t < 0.5 ? 1 + 2 * t : 7, 1e-15);
            EXPECT_NEAR(b.values[j], t < 0.5 ? 5 + 6 * t : 9 - 2 * (t - 0.5), 1e-15);
        }
    }
}

TEST(ValueKernels, CubicPiecesAreTheirPolynomials) {
    ColorPieces pieces;
    pieces.degree = 3;
    pieces.begins = {0.0, 0.25};
    pieces.table = {0.0,  1,  2, 3,  4, 5, 6, 7, 8, 9, 10, 11, 12,
                    0.25, -1, 2, -3, 4, 0, 0, 0, 1, 0, 0,  1,  0};
    Array x, r, g, b;
    for (std::size_t j = 0; j < value_batch; ++j) x.values[j] = double(j) / value_batch;
    look_up(pieces, x.values, value_batch, {r.values, g.values, b.values});
    for (std::size_t j = 0; j < value_batch; ++j) {
        const double t = x.values[j], u = t < 0.25 ? t : t - 0.25;
        EXPECT_NEAR(r.values[j],
                    t < 0.25 ? 1 + u * (2 + u * (3 + u * 4)) : -1 + u * (2 + u * (-3 + u * 4)),
                    1e-14);
        EXPECT_NEAR(b.values[j], t < 0.25 ? 9 + u * (10 + u * (11 + u * 12)) : u * u, 1e-14);
    }
}

TEST(ValueKernels, GiveTheSameBitsOnEveryInstructionSet) {
    std::mt19937 random(6);
    Array a, b, expected, result;
    for (double& v : a.values) v = std::ldexp(uniform(random, -1, 1), int(random() % 30) - 10);
    for (double& v : b.values) v = std::ldexp(uniform(random, -1, 1), int(random() % 30) - 10);
    for (const ValueOp op :
         {ValueOp::affine, ValueOp::ratio, ValueOp::floor, ValueOp::odd, ValueOp::smoothstep,
          ValueOp::lerp, ValueOp::length, ValueOp::power, ValueOp::sine, ValueOp::angle})
        for (const double p : {1.7, 3.0}) {
            const ValueOperation operation{op, {p, 5.5, 0.1, 2.0}};
            const auto run = [&](Array& out) {
                apply(operation, {a.values, b.values, a.values, b.values}, value_batch, out.values);
            };
            run(expected);
            on_every_target([&] {
                run(result);
                for (std::size_t j = 0; j < value_batch; ++j)
                    ASSERT_EQ(result.values[j], expected.values[j])
                        << simd_level() << " " << int(op) << " " << a.values[j];
            });
        }
}

}  // namespace
}  // namespace burl
