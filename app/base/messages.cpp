#include "app/base/messages.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace burl {

namespace {

/// The length in bytes of the UTF-8 character that the text begins with; 0 where it begins with
/// none.
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

/// Whether the UTF-8 character is a control character, C0 (with DEL) or C1.
bool commands_terminals(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    if (character.size() == 1) return first < 0x20 || first == 0x7f;
    return first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
}

bool write_line(std::string_view line, std::FILE* stream) {
    const std::string bytes = printable(line) + "\n";
    return std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size();
}

/// Levenshtein's distance: insertions, deletions and replacements of single characters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row[b.size()];
}

}  // namespace

std::string printable(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        text.remove_prefix(character.size());
        if (length > 0 && !commands_terminals(character)) {
            result += character;
            continue;
        }
        // The second byte of a C1 character is its code; its first, 0xc2, adds nothing.
        const auto code = static_cast<unsigned char>(character.back());
        result += fmt::format("\\x{:02x}", code);
    }
    return result;
}

void print_line(std::string_view line) {
    if (!write_line(line, stdout) || std::fflush(stdout) != 0)
        throw std::system_error(errno, std::generic_category(),
                                "a line cannot be written to stdout");
}

void warn(std::string_view sentence) {
    write_line(sentence, stderr);
}

std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates) {
    std::string_view nearest;
    std::size_t best = std::string_view::npos;
    for (const std::string_view candidate : candidates) {
        const std::size_t distance = edit_distance(word.substr(0, 200), candidate);
        if (distance < best && 2 * distance <= std::max(word.size(), candidate.size()))
            best = distance, nearest = candidate;
    }
    return nearest;
}

}  // namespace burl
