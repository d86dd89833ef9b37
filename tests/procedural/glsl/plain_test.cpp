// GLSL made plain: reals as floats, only what a function needs, numbers that read back the same.
#include "procedural/glsl/plain.h"

#include <gtest/gtest.h>

#include "procedural/glsl/text.h"

namespace burl {
namespace {

TEST(GlslPlain, MakesRealsFloats) {
    EXPECT_EQ(glsl_in_float("exact real3 v = real(0.5) * real3(a) + real(realm);\n"),
              "vec3 v = 0.5 * vec3(a) + float(realm);\n");
    EXPECT_EQ(glsl_in_float("a\n#if REAL_IS_DOUBLE\nreal b;\n#else\nreal2 c;\n#endif\nd\n"),
              "a\nvec2 c;\nd\n");
    EXPECT_EQ(
        glsl_in_float("real_item a[2] = real_item[2](to_item(real(0.5)), to_item(b + real(c)));\n"
                      "real4 d = 2.0 * from_item(e[i]).yzww + from_item(to_item(f));\n"),
        "float a[2] = float[2](0.5, (b + float(c)));\n"
        "vec4 d = 2.0 * e[i].yzww + f;\n");
}

TEST(GlslPlain, KeepsWhatTheRootNeeds) {
    const char* text =
        "// The file's own words.\n"
        "\n"
        "const uint prime = 7u,\n"
        "           other = 5u;\n"
        "const float unused = 1.0;\n"
        "\n"
        "struct Site {\n"
        "    float place;\n"
        "};\n"
        "// Mixes.\n"
        "uint mix_bits(uint h) { return h * prime; }\n"
        "\n"
        "uniform sampler2D image0;\n"
        "float left_out(float place) {\n"
        "    return place * unused;\n"
        "}\n"
        "#define TWICE(x) (x + x)\n"
        "uint root(uint seed) {\n"
        "    return TWICE(mix_bits(seed));  // unlike left_out\n"
        "}\n";
    EXPECT_EQ(glsl_needed_by({"root"}, text),
              "const uint prime = 7u,\n"
              "           other = 5u;\n"
              "\n"
              "// Mixes.\n"
              "uint mix_bits(uint h) { return h * prime; }\n"
              "\n"
              "#define TWICE(x) (x + x)\n"
              "\n"
              "uint root(uint seed) {\n"
              "    return TWICE(mix_bits(seed));  // unlike left_out\n"
              "}\n");
    EXPECT_EQ(glsl_needed_by({"Site"}, text), "struct Site {\n    float place;\n};\n");
    EXPECT_EQ(glsl_needed_by({"nothing"}, text), "");
    EXPECT_EQ(glsl_needed_by({"unused", "nothing", "Site"}, text),
              "const float unused = 1.0;\n"
              "\n"
              "struct Site {\n    float place;\n};\n");
}

TEST(GlslText, NumbersReadBackTheSame) {
    EXPECT_EQ(glsl_number(2.0, GlslReal::float64), "2.0lf");
    EXPECT_EQ(glsl_number(0.1, GlslReal::float32), "0.1");
    EXPECT_EQ(glsl_number(1e30, GlslReal::float64), "1e+30lf");
    for (const double x : {1.0 / 3.0, 1e-300, -6.858999999999999})
        EXPECT_EQ(std::stod(glsl_number(x, GlslReal::float64)), x);
    EXPECT_EQ(std::stof(glsl_number(1.0 / 3.0, GlslReal::float32)), float(1.0 / 3.0));
}

TEST(GlslText, SumsLeaveOutWhatDoesNothing) {
    const auto sum = [](const std::vector<double>& factors, double constant) {
        const std::vector<std::string> names{"a", "b"};
        return glsl_sum(factors, {names.begin(), names.begin() + int(factors.size())}, constant,
                        GlslReal::float32);
    };
    EXPECT_EQ(sum({1.0, -2.5}, 0.5), "a - 2.5 * b + 0.5");
    EXPECT_EQ(sum({-1.0, 1.0}, -3.0), "-a + b - 3.0");
    EXPECT_EQ(sum({2.0}, 0.0), "2.0 * a");
    EXPECT_EQ(glsl_operand("-a"), "(-a)");
}

}  // namespace
}  // namespace burl
