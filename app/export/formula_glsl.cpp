#include "app/export/formula_glsl.h"

#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/base/shader_numbers.h"

namespace burl {

namespace {

/// Translates a formula from left to right: GLSL has the same operators with the same precedence,
/// but numbers without a point are whole, and least and greatest are those of two numbers.
class FormulaWriter {
  public:
    FormulaWriter(std::string_view rest, const std::string& x) : rest_(rest), x_(x) {}

    /// The text up to a comma, an unmatched parenthesis or the end.
    std::string expression() {
        std::string text;
        while (!rest_.empty() && rest_[0] != ',' && rest_[0] != ')') text += part();
        return text;
    }

    bool is_possible() const { return possible_; }

  private:
    std::string part() {
        const char c = rest_[0];
        if ((c >= '0' && c <= '9') || c == '.') return number();
        if (c >= 'a' && c <= 'z') return name();
        rest_.remove_prefix(1);
        if (c == '(') return "(" + closed() + ")";
        // With blanks round them two signs make no "--".
        if (c == ' ' || c == '\t') return "";
        return fmt::format(" {} ", c);
    }

    /// The expression up to its closing parenthesis, and past that.
    std::string closed() {
        std::string text = expression();
        if (!rest_.empty()) rest_.remove_prefix(1);
        return text;
    }

    std::string number() {
        double value = 0.0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        rest_.remove_prefix(std::size_t(end - rest_.data()));
        const float rounded = float(value);
        possible_ = possible_ && error == std::errc() && std::isfinite(rounded) &&
                    (rounded != 0.0f || value == 0.0);
        return shader_number(value);
    }

    /// The variable, or a function with its arguments.
    std::string name() {
        std::size_t size = 0;
        while (size < rest_.size() && rest_[size] >= 'a' && rest_[size] <= 'z') ++size;
        const std::string name(rest_.substr(0, size));
        rest_.remove_prefix(size);
        if (name == "x") return x_;
        rest_.remove_prefix(std::min(rest_.find('(') + 1, rest_.size()));
        std::vector<std::string> arguments{expression()};
        while (rest_.starts_with(',')) {
            rest_.remove_prefix(1);
            arguments.push_back(expression());
        }
        if (!rest_.empty()) rest_.remove_prefix(1);
        if (name == "pow") return fmt::format("formula_power({})", fmt::join(arguments, ", "));
        if (name != "min" && name != "max") return fmt::format("{}({})", name, arguments[0]);
        std::string text = arguments[0];
        for (std::size_t i = 1; i < arguments.size(); ++i)
            text = fmt::format("{}({}, {})", name, text, arguments[i]);
        return arguments.size() == 1 ? "(" + text + ")" : text;
    }

    std::string_view rest_;
    const std::string& x_;
    bool possible_ = true;
};

}  // namespace

std::string formula_glsl(const std::string& formula, const std::string& x) {
    FormulaWriter writer(formula, x);
    const std::string text = writer.expression();
    return writer.is_possible() ? text : "";
}

const char* const formula_power_glsl = R"(
// a to the power b; of a negative a where b is whole.
float formula_power(float a, float b) {
    float size = b == 0.0 ? 1.0 : pow(abs(a), b);
    return a < 0.0 && mod(b, 2.0) == 1.0 ? -size : size;
}
)";

}  // namespace burl
