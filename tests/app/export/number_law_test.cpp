// Laws of a shader's numbers, found from samples that are rounded as shaders have them.
#include "app/export/number_law.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace burl {
namespace {

const std::vector<double> some_u{3.3, 0.5, 1.1, 2.0, 4.7, 6.1, 7.9};

std::vector<double> rounded(const std::vector<double>& u,
                            const std::function<double(double)>& law) {
    std::vector<double> y;
    for (const double x : u) y.push_back(double(float(law(x))));
    return y;
}

/// The text of the law of a number that follows u by a function; "none" where none was found.
std::string law_text(const std::function<double(double)>& law,
                     const std::vector<double>& u = some_u) {
    const auto found = find_law(u, rounded(u, law));
    if (!found) return "none";
    return ProductLaw{{{"u", found->quantity}}, {found->constant, found->factor}}.text();
}

TEST(NumberLaws, AreFoundWithTheirOwnDigits) {
    EXPECT_EQ(law_text([](double u) { return u; }), "u");
    EXPECT_EQ(law_text([](double u) { return -u; }), "-u");
    EXPECT_EQ(law_text([](double u) { return 0.3 * u; }), "0.3 * u");
    EXPECT_EQ(law_text([](double u) { return u / 0.3; }), "u / 0.3");
    EXPECT_EQ(law_text([](double u) { return 0.12 + u; }), "0.12 + u");
    EXPECT_EQ(law_text([](double u) { return 0.25 - 1.7 * u; }), "0.25 - 1.7 * u");
    EXPECT_EQ(law_text([](double u) { return 0.4 / u; }), "0.4 / u");
    EXPECT_EQ(law_text([](double u) { return 5 - 0.4 / u; }), "5.0 - 0.4 / u");
    EXPECT_EQ(law_text([](double u) { return 2 * u * u * u; }), "2.0 * u * u * u");
    EXPECT_EQ(law_text([](double u) { return 2 / (u * u); }), "2.0 / u / u");
}

TEST(NumberLaws, HaveShiftedReciprocals) {
    EXPECT_EQ(law_text([](double u) { return 1 / (u + 0.22); }), "1.0 / (u + 0.22)");
    EXPECT_EQ(law_text([](double u) { return 1 / (u - 0.18); }), "1.0 / (u - 0.18)");
    EXPECT_EQ(law_text([](double u) { return 1 / (9 - u); }), "-1.0 / (u - 9.0)");
    EXPECT_EQ(law_text([](double u) { return 3 - 0.5 / (u + 1.5); }), "3.0 - 0.5 / (u + 1.5)");
}

TEST(NumberLaws, OfNumbersOnBothSidesOfZero) {
    const std::vector<double> u{0.4, -0.9, -0.2, 0.0, 0.7, 0.95};
    EXPECT_EQ(law_text([](double x) { return 0.6 * x; }, u), "0.6 * u");
    EXPECT_EQ(law_text([](double x) { return x - 0.5; }, u), "-0.5 + u");
    EXPECT_EQ(law_text([](double x) { return x * x; }, u), "u * u");
    EXPECT_EQ(law_text([](double x) { return 1 / x; }, u), "none");
}

TEST(NumberLaws, AreNoneOfOtherFunctions) {
    EXPECT_EQ(law_text([](double u) { return std::sin(u); }), "none");
    EXPECT_EQ(law_text([](double u) { return std::sqrt(u); }), "none");
    EXPECT_EQ(law_text([](double u) { return std::min(u, 4.0); }), "none");
    EXPECT_EQ(law_text([](double u) { return 1 + u * u; }), "none");
    EXPECT_EQ(law_text([](double u) { return u * (1 + 1e-5 * u); }), "none");
}

/// A number of two quantities at the four corners of their ranges.
ProductLaw law_of_two(const std::function<double(double, double)>& number) {
    const std::array low{0.5, 2.0}, high{3.0, 5.0};
    const std::array corners{number(low[0], low[1]), number(high[0], low[1]),
                             number(low[0], high[1]), number(high[0], high[1])};
    return law_between({{"a", {}}, {"b", {-1}}}, low, high, corners);
}

TEST(NumberLaws, OfTwoQuantitiesAreSumsOfProducts) {
    const auto number = [](double a, double b) { return 1 + 2 * a - 3 * b + 0.5 * a * b; };
    const ProductLaw law = law_of_two(number);
    EXPECT_NEAR(law.at(std::array{0.7, 4.5}), number(0.7, 4.5), 1e-12);
    EXPECT_EQ(law.text(), "1.0 + 2.0 * a - 3.0 / b + 0.5 * a / b");
    EXPECT_EQ(law_of_two([](double a, double b) { return 2 * a * b; }).text(), "2.0 * a / b");
    EXPECT_TRUE(law.agrees(std::array{0.7, 4.5}, number(0.7, 4.5) * (1 + 1e-8)));
    EXPECT_FALSE(law.agrees(std::array{0.7, 4.5}, number(0.7, 4.5) + 1e-3));
}

TEST(NumberLaws, OfSumsGoThroughTheirNumber) {
    const std::array factors{2.0, -3.0}, values{0.5, 2.0};
    EXPECT_EQ(sum_law({{"a", {}}, {"b", {}}}, factors, values, -1.5).text(),
              "3.5 + 2.0 * a - 3.0 * b");
    EXPECT_EQ(sum_law({{"a", {}}, {"b", {}}}, factors, values, -5.0).text(), "2.0 * a - 3.0 * b");
}

}  // namespace
}  // namespace burl
