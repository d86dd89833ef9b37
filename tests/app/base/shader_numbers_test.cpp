// A shader's text, cut at its numbers and put together again.
#include "app/base/shader_numbers.h"

#include <gtest/gtest.h>

namespace burl {
namespace {

std::vector<double> numbers_in(const char* text) {
    std::vector<double> values;
    for (const ShaderNumber& number : shader_numbers(text).numbers) values.push_back(number.value);
    return values;
}

/// The text with "k" in the place of each number.
std::string with_k(const char* text) {
    const ShaderNumbers cut = shader_numbers(text);
    return with_expressions(cut, std::vector<std::string>(cut.numbers.size(), "k"));
}

/// The text with a sum in the place of each number.
std::string with_sum(const char* text) {
    const ShaderNumbers cut = shader_numbers(text);
    return with_expressions(cut, std::vector<std::string>(cut.numbers.size(), "a + b"));
}

TEST(ShaderNumbers, AreThoseWithAPointOrExponent) {
    EXPECT_EQ(numbers_in("float v1 = 0.5 * at2(3u, 4, 0x9e37u) + 1e-05;"),
              (std::vector<double>{0.5, double(1e-05f)}));
    EXPECT_EQ(numbers_in("v31.x * vec3(1.0, -2.5e3, 7)"), (std::vector<double>{1.0, -2500.0}));
    EXPECT_EQ(numbers_in("// from 0.5 to 1.5\nx = 2.0;"), std::vector<double>{2.0});
    EXPECT_EQ(numbers_in("nothing"), std::vector<double>{});
}

TEST(ShaderNumbers, HaveTheirSigns) {
    EXPECT_EQ(numbers_in("x - 0.5"), std::vector<double>{-0.5});
    EXPECT_EQ(numbers_in("x * (-0.5)"), std::vector<double>{-0.5});
    EXPECT_EQ(numbers_in("sine(-0.5 * x) + 0.25"), (std::vector<double>{-0.5, 0.25}));
    EXPECT_EQ(numbers_in("x-0.5"), std::vector<double>{0.5});
    EXPECT_EQ(numbers_in("x - (-0.5)"), std::vector<double>{0.5});
    EXPECT_EQ(numbers_in("x + (-0.5)"), std::vector<double>{-0.5});
}

TEST(ShaderNumbers, AreTheFloatsThatTextsStandFor) {
    EXPECT_EQ(numbers_in("0.1"), std::vector<double>{double(0.1f)});
}

TEST(ShaderNumbers, TextsThatDifferByNumbersHaveOneStructure) {
    const auto same = [](const char* a, const char* b) {
        return same_structure(shader_numbers(a), shader_numbers(b));
    };
    EXPECT_TRUE(same("v = 0.5 * x + 0.25;", "v = -1.5 * x - 2.0;"));
    EXPECT_TRUE(same("f(x * (-0.5))", "f(x * 0.5)"));
    EXPECT_TRUE(same("v = x - 0.5;", "v = x - (-0.5);"));
    EXPECT_FALSE(same("v = 0.5 * x;", "v = x;"));
    EXPECT_FALSE(same("v = 0.5 * x;", "v = 0.5 * y;"));
    EXPECT_FALSE(same("octave(3u, 0.5)", "octave(4u, 0.5)"));
}

TEST(ShaderNumbers, ComeBackAsTheyWere) {
    const char* text = "const float t[2] = float[2](0.5, -1e-3); // 0.7\nv = x - 0.5 * (-2.0);\n";
    const ShaderNumbers cut = shader_numbers(text);
    EXPECT_EQ(cut.numbers.size(), 4u);
    EXPECT_EQ(with_expressions(cut, std::vector<std::string>(4)), text);
}

TEST(ShaderNumbers, YieldToExpressions) {
    EXPECT_EQ(with_k("v = x - 0.5 * y;"), "v = x + k * y;");
    EXPECT_EQ(with_k("v = x * (-0.5);"), "v = x * k;");
    EXPECT_EQ(with_sum("v = x * (-0.5);"), "v = x * (a + b);");
    EXPECT_EQ(with_sum("v = x - 0.5;"), "v = x + (a + b);");
    EXPECT_EQ(with_sum("v = f(-0.5, 0.5);"), "v = f(a + b, a + b);");
    EXPECT_EQ(with_sum("v = 0.5;"), "v = a + b;");
}

TEST(ShaderNumbers, ConstantsOfExpressionsBecomeVariables) {
    EXPECT_EQ(with_k("const float a = 0.5;"), "float a = k;");
    EXPECT_EQ(with_k("const float t[2] = float[2](\n    0.5, 1.5);"),
              "float t[2] = float[2](\n    k, k);");
    EXPECT_EQ(with_k("const int n = 3;\nfloat a = 0.5;"), "const int n = 3;\nfloat a = k;");
}

}  // namespace
}  // namespace burl
