// Formulas against the same arithmetic in C++, and what is no formula.
#include "app/recipe/edit/formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>

namespace burl {
namespace {

using testing::HasSubstr;

struct KnownFormula {
    const char* text;
    double (*value)(double);
};

const KnownFormula known_formulas[] = {
    {"x", [](double x) { return x; }},
    {"0.0006 / x", [](double x) { return 0.0006 / x; }},
    {"-x+3*(x - 1e-2)/2", [](double x) { return -x + 3 * (x - 1e-2) / 2; }},
    {"sqrt(x)", [](double x) { return std::sqrt(x); }},
    {"abs(1 - x)", [](double x) { return std::abs(1 - x); }},
    {"pow(x, 3) + pow(x, -2)", [](double x) { return x * x * x + 1 / (x * x); }},
    {"pow(-x, 2) * pow(-x, 3)", [](double x) { return -x * x * x * x * x; }},
    {"pow(x, 0.37)", [](double x) { return std::pow(x, 0.37); }},
    {"min(x, 2, 0.5) + max(x, 1)", [](double x) { return std::min(x, 0.5) + std::max(x, 1.0); }},
};

TEST(Formula, HasTheValueOfItsArithmetic) {
    for (const KnownFormula& known : known_formulas) {
        EXPECT_EQ(formula_problem(known.text), "") << known.text;
        for (const double x : {0.001, 0.3, 1.0, 1.75, 20.0, 4096.0}) {
            const double wanted = known.value(x);
            EXPECT_NEAR(formula_value(known.text, x), wanted, 1e-12 * std::abs(wanted))
                << known.text << " at " << x;
        }
    }
}

TEST(Formula, HasNoValueWhereItIsNotDefined) {
    EXPECT_FALSE(std::isfinite(formula_value("1 / x", 0.0)));
    EXPECT_FALSE(std::isfinite(formula_value("sqrt(x)", -1.0)));
    EXPECT_FALSE(std::isfinite(formula_value("pow(x, 0.5)", -1.0)));
    EXPECT_FALSE(std::isfinite(formula_value("pow(x, -1)", 0.0)));
    EXPECT_FALSE(std::isfinite(formula_value("pow(10, x)", 1000.0)));
}

TEST(Formula, IsArithmeticAndNothingElse) {
    for (const char* wrong :
         {"",       " ",     "x = 2", "x, 2",     "x ? 1 : 2", "x < 2",  "x && 1", "x ^ 2",
          "2x",     "x x",   "(x",    "x)",       "x +",       "sin(x)", "sqrt",   "sqrt(x, 2)",
          "pow(x)", "min()", "e",     "pi",       "_pi",       "y",      "1.5.2",  "0x10",
          "\"a\"",  "rnd()", "x; x",  "\xc3\xa4", "#1",        "sum(x)", "avg(x)"})
        EXPECT_NE(formula_problem(wrong), "") << wrong;
    EXPECT_THAT(formula_problem("2 * y"), HasSubstr("\"y\""));
    EXPECT_THAT(formula_problem("x + sin(x)"), HasSubstr("sin"));
    EXPECT_THAT(formula_problem(std::string(300, '1')), HasSubstr("200"));
    EXPECT_NE(formula_problem(std::string(150, '(') + "x"), "");
}

TEST(Formula, KnowsNoLanguage) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "this system has no German";
    EXPECT_EQ(formula_value("1.5 * x", 2.0), 3.0);
    std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace burl
