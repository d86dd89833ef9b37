// Shaders put together from parts: order, names of parts in compilers' messages, `real`.
#include "app/gl/device/objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "app/gl/device/target.h"
#include "procedural/glsl/text.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(ShaderSource, TheVersionComesFirstAndOnce) {
    const std::string text = ShaderSource()
                                 .add("a", "#version 330 core\nvoid f() {}\n")
                                 .extension("GL_ARB_gpu_shader_fp64")
                                 .define("N", "3")
                                 .text();
    EXPECT_THAT(text, StartsWith("#version 330 core\n#extension GL_ARB_gpu_shader_fp64 : require\n"
                                 "#define N 3\n\nvoid f() {}\n"));
}

TEST(ShaderSource, LogsOfAllDriversGetTheNamesOfParts) {
    // #version is line 1 of the whole, the macro 2, noise.glsl 3 and 4, color.frag from 5.
    ShaderSource source;
    source.define("N", "3").add("noise.glsl", "// one\n// two").add("color.frag", "// one\n\n");
    EXPECT_EQ(source.with_names("0:5(3): error: x\n0:4(1): warning: 0:4\n"),
              "color.frag:1(3): error: x\nnoise.glsl:2(1): warning: 0:4\n");
    EXPECT_EQ(source.with_names("0(3) : error C1008: undefined variable"),
              "noise.glsl:1 : error C1008: undefined variable");
    EXPECT_EQ(source.with_names("ERROR: 0:6: 'x' : undeclared\nERROR: 1 compilation errors.\n"),
              "ERROR: color.frag:2: 'x' : undeclared\nERROR: 1 compilation errors.\n");
    EXPECT_EQ(source.with_names("0:2(1): error\n0:99(1): error\n\nmore"),
              "(macros):2(1): error\ncolor.frag:95(1): error\n\nmore");
    EXPECT_EQ(source.with_names(""), "");
}

TEST(ShaderSource, UnknownFilesAreErrors) {
    EXPECT_THROW(ShaderSource().add("no_such.glsl"), Error);
}

using ShaderSourceTest = GlTest;

TEST_F(ShaderSourceTest, ErrorsNameThePartAndItsOwnLine) {
    const ShaderSource fragment =
        ShaderSource()
            .define("ONE", "1.0")
            .add("good.glsl", "float f() { return ONE; }\n\n\n")
            .add("bad.frag", "out vec4 c;\nvoid main() {\n  c = no_such;\n}");
    try {
        make_full_screen_program(context->gl(), "two parts", fragment);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::runtime);
        EXPECT_THAT(error.what(), HasSubstr("fragment shader of two parts"));
        EXPECT_THAT(error.what(), HasSubstr("bad.frag:3"));
        EXPECT_THAT(error.what(), Not(HasSubstr("good.glsl")));
    }
}

TEST_F(ShaderSourceTest, LinkErrorsCarryTheLog) {
    const ShaderSource fragment =
        ShaderSource().add("undefined.frag",
                           "float undefined_function(); out vec4 c;\n"
                           "void main() { c = vec4(undefined_function()); }");
    try {
        make_full_screen_program(context->gl(), "unlinked", fragment);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::unsupported);
        EXPECT_THAT(error.what(), HasSubstr("unlinked do not link"));
        EXPECT_THAT(error.what(), HasSubstr("undefined_function"));
    }
}

/// The bits of 1/3 + x, in whatever `real` is.
std::uint64_t third_plus(const GladGLContext& gl, bool float64, double x) {
    const ShaderSource fragment =
        ShaderSource().define_real(float64).add("real.frag",
                                                "uniform real x; out uvec2 bits;\n"
                                                "void main() {\n"
                                                "    real y = real(1.0) / real(3.0) + x;\n"
                                                "#if BURL_FLOAT64\n"
                                                "    bits = unpackDouble2x32(y);\n"
                                                "#else\n"
                                                "    bits = uvec2(floatBitsToUint(y), 0u);\n"
                                                "#endif\n"
                                                "}");
    ShaderSource with_bits = fragment;
    with_bits.extension("GL_ARB_shader_bit_encoding");
    const GlProgram program = make_full_screen_program(gl, "reals", with_bits);
    const GlTarget target(gl, {1, 1}, {GL_RG32UI});
    target.bind();
    program.use();
    if (float64)
        program.set("x", x);
    else
        program.set("x", float(x));
    GlFullScreen(gl).draw();
    const auto words = target.read<std::uint32_t>();
    return words[0] | std::uint64_t(words[1]) << 32;
}

TEST_F(ShaderSourceTest, RealIsDoubleWhereAskedFor) {
    const double x = 1e-9;
    if (has_float64(context->gl())) {
        EXPECT_EQ(third_plus(context->gl(), true, x), std::bit_cast<std::uint64_t>(1.0 / 3.0 + x));
    }
    EXPECT_EQ(third_plus(context->gl(), false, x),
              std::bit_cast<std::uint32_t>(1.0f / 3.0f + float(x)));
}

/// The sum of a product of items and an element of a table, all indexed by a variable. (NVIDIA's
/// compiler keeps such arrays of float64 in float32.)
TEST_F(ShaderSourceTest, ArraysThatAVariableIndexesKeepFloat64) {
    const GladGLContext& gl = context->gl();
    if (!has_float64(gl)) GTEST_SKIP() << "no float64";
    const double x = 1.0 / 3.0, numbers[] = {0.1, 2.0 / 3.0, 3.141592653589793};
    ShaderSource fragment;
    fragment.define_real(true).add("numbers/real.glsl");
    fragment.add("table", glsl_array("table", numbers, 1, GlslReal::float64));
    fragment.add(
        "main",
        "uniform real x; uniform int first; out uvec2 bits;\n"
        "void main() {\n"
        "    real_item a[3] = real_item[3](to_item(-x), to_item(x), to_item(x + x));\n"
        "    real4_item b[2] = real4_item[2](to_item(real4(x)), to_item(real4(x / 7.0)));\n"
        "    exact real product = from_item(a[first]) * from_item(b[first]).w;\n"
        "    exact real sum = product + table(first + 1);\n"
        "    bits = unpackDouble2x32(sum);\n"
        "}");
    const GlProgram program = make_full_screen_program(gl, "items", fragment);
    const GlTarget target(gl, {1, 1}, {GL_RG32UI});
    target.bind();
    program.use();
    program.set("x", x);
    program.set("first", 1);
    GlFullScreen(gl).draw();
    const auto words = target.read<std::uint32_t>();
    const double product = x * (x / 7.0);
    EXPECT_EQ(words[0] | std::uint64_t(words[1]) << 32,
              std::bit_cast<std::uint64_t>(product + numbers[2]));
}

}  // namespace
}  // namespace burl
