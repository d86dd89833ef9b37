#include "procedural/glsl_text.h"

#include <cmath>

#include <fmt/format.h>

namespace burl {

std::string glsl_number(double value, GlslReal real) {
    std::string text =
        real == GlslReal::float64 ? fmt::format("{}", value) : fmt::format("{}", float(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    if (real == GlslReal::float64) text += "lf";
    return text;
}

std::string glsl_operand(const std::string& text) {
    return text.starts_with('-') ? fmt::format("({})", text) : text;
}

std::string glsl_sum(const std::vector<double>& factors, const std::vector<std::string>& terms,
                     double constant, GlslReal real) {
    std::string sum;
    const auto add = [&](bool negative, const std::string& term) {
        const char* sign = sum.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        sum += sign;
        sum += term;
    };
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const double size = std::abs(factors[i]);
        add(factors[i] < 0.0,
            size == 1.0 ? terms[i] : fmt::format("{} * {}", glsl_number(size, real), terms[i]));
    }
    if (constant != 0.0 || sum.empty()) add(constant < 0.0, glsl_number(std::abs(constant), real));
    return sum;
}

}  // namespace burl
