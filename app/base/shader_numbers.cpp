#include "app/base/shader_numbers.h"

#include <algorithm>
#include <charconv>

#include "procedural/glsl/text.h"

namespace burl {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Whether a word of GLSL may contain the character.
bool is_word(char c) {
    return is_digit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Whether an operand may end with the character, so that a sign after it is an operator.
bool ends_operand(char c) {
    return is_word(c) || c == ')' || c == ']' || c == '.';
}

class NumberCutter {
  public:
    explicit NumberCutter(std::string_view text) : text_(text) {}

    ShaderNumbers cut() {
        while (at_ < text_.size()) {
            if (text_.substr(at_, 2) == "//")
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (is_digit(text_[at_]))
                read_number();
            else if (is_word(text_[at_]))
                skip_word();
            else
                ++at_;
        }
        result_.around.emplace_back(text_.substr(done_));
        return std::move(result_);
    }

  private:
    void skip_word() {
        while (at_ < text_.size() && is_word(text_[at_])) ++at_;
    }

    void read_number() {
        ShaderNumber number;
        const char* begin = text_.data() + at_;
        float value = 0.0f;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        number.value = double(value);
        const std::string_view digits(begin, std::size_t(end - begin));
        const std::size_t from = at_;
        at_ += digits.size();
        skip_word();  // "u", "lf", or the rest of a number with "0x"
        if (digits.find_first_of(".e") != std::string_view::npos) add(number, from);
    }

    char before(std::size_t place, std::size_t steps) const {
        return place >= done_ + steps ? text_[place - steps] : '\n';
    }

    bool is_sign(char c) const { return c == '+' || c == '-'; }

    /// Whether the place follows an operator of sums and its operand.
    bool is_added(std::size_t place) const {
        return before(place, 1) == ' ' && is_sign(before(place, 2)) && before(place, 3) == ' ' &&
               ends_operand(before(place, 4));
    }

    /// Takes the number's own sign, and the parentheses round both.
    void take_sign(std::size_t& from) {
        if (before(from, 1) != '-' || ends_operand(before(from, 2)) || is_added(from)) return;
        if (before(from, 2) == ' ' && ends_operand(before(from, 3))) return;
        --from;
        if (before(from, 1) == '(' && !is_word(before(from, 2)) && at_ < text_.size() &&
            text_[at_] == ')') {
            --from;
            ++at_;
        }
    }

    /// Adds the number at `from`, which ends at at_, with its signs: "- 0.5" and "- (-0.5)" are
    /// numbers that are added.
    void add(ShaderNumber number, std::size_t from) {
        take_sign(from);
        number.added = is_added(from);
        if (number.added) from -= 2;
        number.spelt = text_.substr(from, at_ - from);
        const auto signs =
            std::string_view(number.spelt).substr(0, number.spelt.find_first_of("0123456789"));
        if (std::ranges::count(signs, '-') % 2 != 0) number.value = -number.value;
        result_.around.emplace_back(text_.substr(done_, from - done_));
        result_.numbers.push_back(std::move(number));
        done_ = at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;    ///< what is before it has been read
    std::size_t done_ = 0;  ///< what is before it is in the result
    ShaderNumbers result_;
};

/// Whether an expression needs no parentheses, being a name.
bool is_name(const std::string& text) {
    return std::ranges::all_of(text, [](char c) { return is_word(c) || c == '.'; });
}

/// Whether an expression between two texts needs no parentheses: it is all of an argument or value.
bool is_whole_operand(const std::string& before, const std::string& after) {
    return (before.ends_with('(') || before.ends_with(", ") || before.ends_with(" = ")) &&
           (after.starts_with(')') || after.starts_with(',') || after.starts_with(';'));
}

/// Takes "const" from the declaration in the midst of which the text ends.
void make_variable(std::string& text) {
    const std::size_t at = text.rfind("const ");
    if (at == std::string::npos || text.find_first_of(";{}", at) != std::string::npos) return;
    if (at == 0 || text[at - 1] == '\n' || text[at - 1] == ' ') text.erase(at, 6);
}

}  // namespace

std::string shader_number(double x) {
    return glsl_number(x, GlslReal::float32);
}

ShaderNumbers shader_numbers(std::string_view text) {
    return NumberCutter(text).cut();
}

bool same_structure(const ShaderNumbers& a, const ShaderNumbers& b) {
    return a.around == b.around &&
           std::ranges::equal(a.numbers, b.numbers, {}, &ShaderNumber::added, &ShaderNumber::added);
}

std::string with_expressions(const ShaderNumbers& text, std::span<const std::string> expressions) {
    std::string result = text.around[0];
    for (std::size_t i = 0; i < text.numbers.size(); ++i) {
        const ShaderNumber& number = text.numbers[i];
        const std::string& wanted = expressions[i];
        if (wanted.empty()) {
            result += number.spelt;
        } else {
            make_variable(result);
            if (number.added) result += "+ ";
            const bool bare = is_name(wanted) || is_whole_operand(result, text.around[i + 1]);
            result += bare ? wanted : "(" + wanted + ")";
        }
        result += text.around[i + 1];
    }
    return result;
}

}  // namespace burl
