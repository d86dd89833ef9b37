#include "atlas/base/utf8.h"

#include <algorithm>

namespace burl {

std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xc2 ? 0
                               : lead < 0xe0 ? 2
                               : lead < 0xf0 ? 3
                               : lead < 0xf5 ? 4
                                             : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0U) != 0x80) return 0;
    if (length < 3) return length;
    // Invalid forms: overlong encodings, UTF-16 surrogates, code points beyond U+10FFFF.
    const unsigned front = lead << 8U | byte(1);
    const bool wrong = front < 0xe0a0 || (front >= 0xeda0 && front < 0xee00) ||
                       (front >= 0xf000 && front < 0xf090) || front >= 0xf490;
    return wrong ? 0 : length;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

bool commands_terminals(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    if (character.size() == 1) return first < 0x20 || first == 0x7f;
    return first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
}

std::string legible(std::string_view text, std::size_t longest) {
    std::string clean;
    std::string_view rest = text;
    while (!rest.empty()) {
        const std::size_t length = utf8_length(rest);
        const std::string_view character = rest.substr(0, std::max<std::size_t>(1, length));
        if (text.size() - rest.size() + character.size() > longest) return clean + "...";
        clean += length > 0 && !commands_terminals(character) ? character : "?";
        rest.remove_prefix(character.size());
    }
    return clean;
}

}  // namespace burl
