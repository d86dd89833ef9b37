#pragma once
// Characters of texts that others wrote, for messages.
#include <cstddef>
#include <string>
#include <string_view>

namespace burl {

/// The length in bytes of the UTF-8 character that the text, which is not empty, begins with; 0
/// where it begins with none.
std::size_t utf8_length(std::string_view text);

/// Whether the whole text is UTF-8, as every string of JSON must be before it is printed.
bool is_utf8(std::string_view text);

/// Whether the UTF-8 character is a control character, C0 (with DEL) or C1.
bool commands_terminals(std::string_view character);

/// The characters within the first `longest` bytes of the text, with '?' for every control
/// character and every byte that is no UTF-8, so that a message stays one line; "..." where more
/// follows.
std::string legible(std::string_view text, std::size_t longest);

}  // namespace burl
