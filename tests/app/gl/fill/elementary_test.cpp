// Sine, angle and powers in shaders: the host's bits in float64, stated errors in float32.
#include <bit>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "procedural/graph/value_kernels.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

constexpr int side = 64;
constexpr std::size_t count = side * side;

struct Arguments {
    alignas(64) double a[count + batch_padding] = {}, b[count + batch_padding] = {};
};

class GlElementaryTest : public GlTest {
  protected:
    /// `expression` of real a and b.
    std::vector<double> draw(const char* expression, const Arguments& arguments, bool float64) {
        const GladGLContext& gl = context->gl();
        std::vector<std::uint64_t> words;
        for (std::size_t i = 0; i < count; ++i)
            words.insert(words.end(), {std::bit_cast<std::uint64_t>(arguments.a[i]),
                                       std::bit_cast<std::uint64_t>(arguments.b[i])});
        const GlTexture texture =
            make_texture(gl, GL_RGBA32UI, {side, side}, std::as_bytes(std::span(words)));
        ShaderSource source;
        source.define_real(float64).add("numbers/real.glsl").add("numbers/real_bits.glsl");
        source.add("numbers/elementary.glsl")
            .add("main", fmt::format(R"(
uniform usampler2D arguments;
layout(location = 0) out uvec2 result;
void main() {{
    uvec4 words = texelFetch(arguments, ivec2(gl_FragCoord.xy), 0);
    real a = real_from_bits(words.x, words.y), b = real_from_bits(words.z, words.w);
#if REAL_IS_DOUBLE
    result = unpackDouble2x32({0});
#else
    result = uvec2(floatBitsToUint({0}), 0u);
#endif
}})",
                                     expression));
        const GlProgram program = make_full_screen_program(gl, "elementary functions", source);
        const GlTarget target(gl, {side, side}, {GL_RG32UI});
        target.bind();
        program.use();
        program.set("arguments", 0);
        bind_texture(gl, 0, texture);
        GlFullScreen(gl).draw();
        const auto read = target.read<std::uint32_t>();
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint64_t low = read[2 * i], high = read[2 * i + 1];
            values.push_back(float64 ? std::bit_cast<double>(low | high << 32)
                                     : double(std::bit_cast<float>(read[2 * i])));
        }
        return values;
    }

    void expect_bits(const char* expression, const ValueOperation& operation,
                     const Arguments& arguments) {
        alignas(64) double expected[count + batch_padding];
        apply(operation, {arguments.a, arguments.b, nullptr, nullptr}, count, expected);
        expect_bits(expression, expected, arguments);
    }

    void expect_bits(const char* expression, const double* expected, const Arguments& arguments) {
        const std::vector<double> values = draw(expression, arguments, true);
        std::size_t different = 0;
        for (std::size_t i = 0; i < count; ++i)
            if (std::bit_cast<std::uint64_t>(values[i]) !=
                    std::bit_cast<std::uint64_t>(expected[i]) &&
                different++ == 0)
                ADD_FAILURE() << expression << " of " << arguments.a[i] << " and " << arguments.b[i]
                              << ": " << values[i] << " not " << expected[i];
        EXPECT_EQ(different, 0u) << expression;
    }

    /// `arguments` are rounded to float first.
    double float32_error(const char* expression, const Arguments& exact_arguments,
                         const std::function<double(double, double)>& exact) {
        Arguments arguments = exact_arguments;
        for (double* values : {arguments.a, arguments.b})
            for (std::size_t i = 0; i < count; ++i) values[i] = double(float(values[i]));
        const std::vector<double> values = draw(expression, arguments, false);
        double error = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const double away = std::abs(values[i] - exact(arguments.a[i], arguments.b[i]));
            error = std::max(error, away <= 1e9 ? away : 1e9);
        }
        return error;
    }

    static Arguments arguments(double reach, double decades) {
        Arguments made;
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        const auto any = [&] {
            const double factor = reach * unit(random);
            return factor * std::pow(10.0, decades * unit(random));
        };
        for (std::size_t i = 0; i < count; ++i) made.a[i] = any(), made.b[i] = any();
        const double zeros[] = {0.0, -0.0, 1.0, -1.0};
        for (std::size_t i = 0; i < 16; ++i) {
            made.a[i] = zeros[i % 4];
            made.b[i] = zeros[i / 4];
        }
        return made;
    }
};

TEST_F(GlElementaryTest, HaveTheHostsBitsInFloat64) {
    for (const auto& [reach, decades] : {std::pair{10.0, 0.0}, {1e4, 3.0}, {1e3, 17.0}}) {
        const Arguments some = arguments(reach, decades);
        expect_bits("sine(a)", {ValueOp::sine, {}}, some);
        expect_bits("angle(a, b)", {ValueOp::angle, {}}, some);
        expect_bits("power(a, 2.5lf)", {ValueOp::power, {2.5}}, some);
        expect_bits("power(a, 0.1lf)", {ValueOp::power, {0.1}}, some);
        expect_bits("whole_power(a, 7u)", {ValueOp::power, {7.0}}, some);
        expect_bits("whole_power(a, 0u)", {ValueOp::power, {0.0}}, some);
    }
}

TEST_F(GlElementaryTest, QuotientsAndRootsAreTheNearestInFloat64) {
    const Arguments some = arguments(10.0, 3.0);
    alignas(64) double quotients[count + batch_padding], roots[count + batch_padding];
    for (std::size_t i = 0; i < count; ++i) {
        quotients[i] = some.a[i] / (1.5 + std::abs(some.b[i]));
        roots[i] = std::sqrt(std::abs(some.a[i]));
    }
    expect_bits("a / (1.5lf + abs(b))", quotients, some);
    expect_bits("(real3(1.0lf, a, 2.0lf) / (1.5lf + abs(b))).y", quotients, some);
    expect_bits("nearest_root(abs(a))", roots, some);
}

TEST_F(GlElementaryTest, StayWithinTheErrorsStatedInFloat32) {
    const auto sine = [](double a, double) { return std::sin(a); };
    EXPECT_LT(float32_error("sine(a)", arguments(8.0, 0.0), sine), 3e-7);
    EXPECT_LT(float32_error("sine(a)", arguments(32768.0, 0.0), sine), 3e-7);
    const auto angle = [](double a, double b) {  // shaders take -0 for 0 here
        return a == 0.0 && b == 0.0 ? 0.0 : std::atan2(a + 0.0, b);
    };
    EXPECT_LT(float32_error("angle(a, b)", arguments(3.0, 3.0), angle), 6e-7);
    const auto log2 = [](double a, double) { return std::log2(std::abs(a) + 1.0); };
    EXPECT_LT(float32_error("binary_log(abs(a) + 1.0)", arguments(4.0, 0.0), log2), 6e-7);
    const auto exp2 = [](double a, double) { return std::exp2(-std::abs(a)); };
    EXPECT_LT(float32_error("binary_power(-abs(a))", arguments(40.0, 1.0), exp2), 2e-7);
    const auto power = [](double a, double) { return a > 0.0 ? std::pow(a, 2.4) : 0.0; };
    EXPECT_LT(float32_error("power(a, 2.4)", arguments(1.0, 0.0), power), 1e-6);
}

}  // namespace
}  // namespace burl
