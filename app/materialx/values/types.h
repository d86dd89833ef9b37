#pragma once
// The types of MaterialX's values that a recipe can hold, and values as a document spells them.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/base/enum_names.h"

namespace burl {

namespace materialx {

/// The types of values made of numbers.
enum class Type { number, integer, boolean, vector2, vector3, vector4, color3, color4 };

}  // namespace materialx

template <>
inline constexpr auto enum_names<materialx::Type> = enum_words("float", "integer", "boolean",
                                                               "vector2", "vector3", "vector4",
                                                               "color3", "color4");

namespace materialx {

/// How many numbers a value has: 1 to 4.
std::size_t size_of(Type type);
bool is_color(Type type);
inline bool is_number(Type type) {
    return size_of(type) == 1;
}

/// The numbers in a text such as "0.5, 1, 2"; none where it holds anything else, a number that is
/// not finite or one beyond 1e9.
std::optional<std::vector<double>> numbers_in(std::string_view text);

/// The numbers of a value of the type; none where the text is no such value.
std::optional<std::vector<double>> parse_value(Type type, std::string_view text);

}  // namespace materialx

}  // namespace burl
