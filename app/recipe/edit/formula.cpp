#include "app/recipe/edit/formula.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <muParser.h>

#include "atlas/base/elementary.h"

namespace burl {

namespace {

constexpr std::size_t longest_formula = 200;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// All that a formula is written with; comparisons, assignments and strings of the library have
/// other characters.
constexpr const char* formula_characters = "0123456789.eExabimnopqrstw+-*/(), \t";

double square_root(double a) {
    return std::sqrt(a);
}

double magnitude(double a) {
    return std::abs(a);
}

/// a^b; not a number where it is not real.
double real_power(double a, double b) {
    const bool whole = b == std::floor(b);
    if (a == 0.0 && b < 0.0) return std::numeric_limits<double>::infinity();
    if (a < 0.0 && !whole) return not_a_number;
    if (!whole || !(std::abs(b) <= 1024.0)) return a < 0.0 ? not_a_number : power(a, b);
    return b < 0.0 ? 1.0 / power(a, -b) : power(a, b);
}

double least(const double* all, int count) {
    return *std::min_element(all, all + count);
}

double most(const double* all, int count) {
    return *std::max_element(all, all + count);
}

/// The library's parser with our functions in place of its own; `x` must outlive it.
mu::Parser parser_of(const std::string& formula, double& x) {
    mu::Parser parser;
    parser.ClearFun();
    parser.ClearConst();
    parser.DefineFun("sqrt", square_root);
    parser.DefineFun("abs", magnitude);
    parser.DefineFun("pow", real_power);
    parser.DefineFun("min", least);
    parser.DefineFun("max", most);
    parser.DefineVar("x", &x);
    parser.SetExpr(formula);
    return parser;
}

}  // namespace

std::string formula_problem(const std::string& formula) {
    if (formula.size() > longest_formula)
        return fmt::format("is longer than {} characters", longest_formula);
    const std::size_t odd = formula.find_first_not_of(formula_characters);
    if (odd != std::string::npos)
        return fmt::format("has \"{}\", which formulas do not", formula.substr(odd, 1));
    try {
        double x = 1.0;
        mu::Parser parser = parser_of(formula, x);
        int results = 0;
        parser.Eval(results);
        return results == 1 ? "" : "has a comma outside of a function";
    } catch (const mu::ParserError& error) {
        const bool token = !error.GetToken().empty();
        return token ? fmt::format("makes no sense at \"{}\"", error.GetToken())
                     : std::string("makes no sense: something is missing");
    }
}

double formula_value(const std::string& formula, double x) {
    try {
        return parser_of(formula, x).Eval();
    } catch (const mu::ParserError&) {
        return not_a_number;
    }
}

}  // namespace burl
