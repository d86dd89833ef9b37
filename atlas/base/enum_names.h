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

/// Whether the enumeration has an enumerator of this value: compilers print any other as a cast.
template <auto value>
constexpr bool is_enumerator() {
    return std::string_view(__PRETTY_FUNCTION__).find("value = (") == std::string_view::npos;
}

/// Whether every enumerator has a word, and every word an enumerator.
template <NamedEnum Enum>
inline constexpr bool has_all_words =
    is_enumerator<Enum(enum_names<Enum>.size() - 1)>() &&
    !is_enumerator<Enum(enum_names<Enum>.size())>() &&
    std::ranges::none_of(enum_names<Enum>, [](std::string_view word) { return word.empty(); });

template <NamedEnum Enum>
constexpr std::string_view to_string(Enum value) {
    static_assert(has_all_words<Enum>);
    return enum_names<Enum>[std::size_t(value)];
}

/// The enumerator of a word; empty where no enumerator has it.
template <NamedEnum Enum>
constexpr std::optional<Enum> enum_named(std::string_view word) {
    static_assert(has_all_words<Enum>);
    const auto found = std::ranges::find(enum_names<Enum>, word);
    if (found == enum_names<Enum>.end()) return {};
    return Enum(found - enum_names<Enum>.begin());
}

}  // namespace burl
