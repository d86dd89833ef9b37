#include "app/gl/device/literals.h"

#include <bit>
#include <cctype>
#include <charconv>
#include <cstdint>

#include <fmt/format.h>

namespace burl {

namespace {

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

/// The literal's number in a form that every compiler reads alike.
std::string exact_literal(double value, std::string_view spelt) {
    if (double(float(value)) == value) return std::string(spelt);
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return fmt::format("packDouble2x32(uvec2({:#x}u, {:#x}u))", std::uint32_t(bits), bits >> 32);
}

/// The length of the float64 literal at the text's beginning, and its number; 0 where there is
/// none.
std::size_t literal_length(std::string_view text, double& value) {
    if (text.empty() || (std::isdigit(static_cast<unsigned char>(text[0])) == 0 && text[0] != '.'))
        return 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    const auto length = std::size_t(end - text.data());
    const std::string_view suffix = text.substr(length, 2);
    if (failure != std::errc() || (suffix != "lf" && suffix != "LF")) return 0;
    return length + 2 < text.size() && is_word(text[length + 2]) ? 0 : length + 2;
}

}  // namespace

std::string with_exact_literals(std::string_view glsl) {
    std::string result;
    result.reserve(glsl.size());
    for (std::size_t at = 0; at < glsl.size();) {
        double value = 0.0;
        const bool begins = at == 0 || !is_word(glsl[at - 1]);
        const std::size_t length = begins ? literal_length(glsl.substr(at), value) : 0;
        if (length > 0)
            result += exact_literal(value, glsl.substr(at, length));
        else
            result += glsl[at];
        at += length > 0 ? length : 1;
    }
    return result;
}

}  // namespace burl
