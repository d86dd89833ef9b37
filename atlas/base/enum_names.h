#pragma once
// The words for enumerations that people read and write, in recipes, on the command line and in
// reports: each enumeration has one table of them.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace burl {

/// A std::array of the enumerators' words, in the order of their values, which go from 0 on; to be
/// specialised with enum_words() for every enumeration that has words.
template <class Enum>
inline constexpr std::nullptr_t enum_names = nullptr;

template <class... Words>
constexpr std::array<std::string_view, sizeof...(Words)> enum_words(const Words&... words) {
    return {words...};
}

template <class Enum>
concept NamedEnum = requires {
    enum_names<Enum>.size();
};

template <NamedEnum Enum>
constexpr std::string_view to_string(Enum value) {
    return enum_names<Enum>[std::size_t(value)];
}

/// The enumerator of a word; empty where no enumerator has it.
template <NamedEnum Enum>
constexpr std::optional<Enum> enum_named(std::string_view word) {
    const auto found = std::ranges::find(enum_names<Enum>, word);
    if (found == enum_names<Enum>.end()) return {};
    return Enum(found - enum_names<Enum>.begin());
}

}  // namespace burl
