#include "atlas/base/glob.h"

namespace burl {

namespace {

/// The number of bytes of the character of UTF-8 that the text begins with; it is not empty.
std::size_t character_size(std::string_view text) {
    std::size_t size = 1;
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xc0u) == 0x80u) ++size;
    return size;
}

}  // namespace

// The text that the last * stands for grows by a character wherever what follows it does not fit;
// an earlier * never needs to grow again.
bool matches_glob(std::string_view name, std::string_view pattern) {
    std::string_view grown, after_star;
    bool star = false;
    while (!name.empty()) {
        if (!pattern.empty() && pattern[0] == '*') {
            pattern.remove_prefix(1);
            star = true, grown = name, after_star = pattern;
        } else if (!pattern.empty() && pattern[0] == '?') {
            pattern.remove_prefix(1);
            name.remove_prefix(character_size(name));
        } else if (!pattern.empty() && pattern[0] == name[0]) {
            pattern.remove_prefix(1);
            name.remove_prefix(1);
        } else if (star) {
            grown.remove_prefix(character_size(grown));
            name = grown, pattern = after_star;
        } else {
            return false;
        }
    }
    while (!pattern.empty() && pattern[0] == '*') pattern.remove_prefix(1);
    return pattern.empty();
}

}  // namespace burl
