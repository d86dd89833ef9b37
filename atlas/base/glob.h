#pragma once
// Patterns with wildcards over names, as users write them to choose meshes and materials.
#include <cstddef>
#include <string_view>

namespace burl {

/// Whether the whole name matches the pattern, in which * stands for any number of bytes and ? for
/// one; case counts. Takes at most name.size() * pattern.size() steps.
inline bool matches_glob(std::string_view name, std::string_view pattern) {
    std::size_t n = 0, p = 0, star = std::string_view::npos, retry = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            retry = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++retry;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

}  // namespace burl
