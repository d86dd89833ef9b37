#include "app/materialx/values/types.h"

#include <array>
#include <charconv>
#include <cmath>

namespace burl::materialx {

namespace {

/// The largest number that a recipe may hold.
constexpr double largest_number = 1e9;

constexpr std::string_view blanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::optional<double> number_in(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) return {};
    if (!(std::abs(value) <= largest_number)) return {};
    return value;
}

}  // namespace

std::size_t size_of(Type type) {
    constexpr std::array<std::size_t, enum_names<Type>.size()> sizes{1, 1, 1, 2, 3, 4, 3, 4};
    return sizes[std::size_t(type)];
}

bool is_color(Type type) {
    return type == Type::color3 || type == Type::color4;
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
    std::vector<double> all;
    for (;;) {
        const std::size_t comma = text.find(',');
        const auto number = number_in(text.substr(0, comma));
        if (!number) return {};
        all.push_back(*number);
        if (comma == std::string_view::npos) return all;
        text.remove_prefix(comma + 1);
    }
}

std::optional<std::vector<double>> parse_value(Type type, std::string_view text) {
    if (type == Type::boolean) {
        const std::string_view word = trimmed(text);
        if (word == "true" || word == "false") return std::vector{word == "true" ? 1.0 : 0.0};
        return {};
    }
    auto numbers = numbers_in(text);
    if (!numbers || numbers->size() != size_of(type)) return {};
    if (type == Type::integer && numbers->front() != std::floor(numbers->front())) return {};
    return numbers;
}

}  // namespace burl::materialx
