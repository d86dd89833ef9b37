// Formulas of controls as GLSL, against the formulas' own values.
#include "app/export/formula_glsl.h"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/gl/device/objects.h"
#include "app/gl/device/target.h"
#include "app/recipe/edit/formula.h"
#include "tests/app/gl/device/fixture.h"

namespace burl {
namespace {

TEST(FormulaGlsl, HasNumbersAndFunctionsOfGlsl) {
    EXPECT_EQ(formula_glsl("x*2/9", "k"), "k * 2.0 / 9.0");
    EXPECT_EQ(formula_glsl("-x", "k"), " - k");
    EXPECT_EQ(formula_glsl("1--x", "k"), "1.0 -  - k");
    EXPECT_EQ(formula_glsl("min(1, x + .12, 2)", "k"), "min(min(1.0, k + 0.12), 2.0)");
    EXPECT_EQ(formula_glsl("max(x)", "k"), "(k)");
    EXPECT_EQ(formula_glsl("pow(abs(x), 1e-1)", "k"), "formula_power(abs(k), 0.1)");
}

TEST(FormulaGlsl, IsNothingForNumbersBeyondFloats) {
    EXPECT_EQ(formula_glsl("x * 1e60", "k"), "");
    EXPECT_EQ(formula_glsl("x / 1e-60", "k"), "");
    EXPECT_EQ(formula_glsl("x * 0", "k"), "k * 0.0");
}

constexpr std::array formulas{"x * 2 / 9",
                              "1 - -x * 3",
                              "1 / (x + 4) - 2",
                              "min(1, x + 0.12)",
                              "max(-1, x, 0.5, 2 * x)",
                              "sqrt(abs(x)) * 1.5e0",
                              "pow(x, 3) + pow(x, 2) - pow(x, 0)",
                              "pow(x - 4, -3)",
                              "pow(abs(x) + 0.5, 0.37)",
                              "-(x - (2 - x)) * (3 + x) / 2"};

class GlFormulaTest : public GlTest {};

TEST_F(GlFormulaTest, ShadersHaveTheirValues) {
    const GladGLContext& gl = context->gl();
    std::string text = "uniform float x[8];\nlayout(location = 0) out vec4 color;\n";
    text += formula_power_glsl;
    text += "float value(int i, float x) {\n";
    for (std::size_t i = 0; i < formulas.size(); ++i)
        text += fmt::format("    if (i == {}) return {};\n", i, formula_glsl(formulas[i], "x"));
    text +=
        "    return 0.0;\n}\nvoid main() {\n"
        "    color = vec4(value(int(gl_FragCoord.y), x[int(gl_FragCoord.x)]));\n}\n";
    constexpr std::array<float, 8> xs{-3.0f, -1.5f, -0.25f, 0.0f, 0.3f, 1.0f, 2.0f, 6.5f};
    const GlProgram program =
        make_full_screen_program(gl, "formulas", ShaderSource().add("formulas", text));
    const GlTarget target(gl, {int(xs.size()), int(formulas.size())}, {GL_RGBA32F});
    target.bind();
    program.use();
    for (std::size_t k = 0; k < xs.size(); ++k) program.set(fmt::format("x[{}]", k).c_str(), xs[k]);
    GlFullScreen(gl).draw();
    const std::vector<float> drawn = target.read<float>();
    for (std::size_t i = 0; i < formulas.size(); ++i) {
        ASSERT_EQ(formula_problem(formulas[i]), "") << formulas[i];
        for (std::size_t k = 0; k < xs.size(); ++k) {
            const double wanted = formula_value(formulas[i], double(xs[k]));
            if (!std::isfinite(wanted)) continue;
            EXPECT_NEAR(drawn[4 * (xs.size() * i + k)], wanted, 1e-5 * (1 + std::abs(wanted)))
                << formulas[i] << " at " << xs[k];
        }
    }
}

}  // namespace
}  // namespace burl
