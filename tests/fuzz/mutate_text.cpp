// Changes of text by lines and words.
#include <algorithm>

#include "tests/fuzz/mutate.h"

namespace burl::fuzz {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        lines.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

/// Begin and length of a word near a random place.
std::pair<std::size_t, std::size_t> any_word(const std::string& text, Random& random) {
    constexpr auto space = " \t\r\n,/\"=<>";
    const std::size_t begin = text.find_first_not_of(space, below(random, text.size()));
    if (begin == std::string::npos) return {text.size(), 0};
    return {begin, std::min(text.find_first_of(space, begin), text.size()) - begin};
}

std::string changed_word(std::string text, std::span<const std::string_view> words,
                         Random& random) {
    const auto [begin, count] = any_word(text, random);
    if (words.empty() || below(random, 3) == 0) {
        const auto [other, length] = any_word(text, random);
        return text.replace(begin, count, text.substr(other, length));
    }
    const std::string_view word = words[below(random, words.size())];
    return text.replace(begin, below(random, 3) == 0 ? 0 : count, word);
}

/// A line many times, each with another number at its end; bad algorithms take quadratic time.
void swell(std::vector<std::string>& lines, std::size_t at, std::size_t room) {
    std::string line = lines[at];
    const bool ends = line.ends_with('\n');
    if (ends) line.pop_back();
    std::string many = lines[at];
    for (int i = 0; many.size() + line.size() + 8 < room; ++i)
        many += line + std::to_string(i) + '\n';
    lines[at] = many;
}

}  // namespace

std::string mutated_text(const std::string& text, std::span<const std::string_view> words,
                         std::size_t most, Random& random) {
    if (text.empty()) return words.empty() ? "\n" : std::string(words[below(random, words.size())]);
    if (below(random, 2) == 0) return changed_word(text, words, random);
    std::vector<std::string> lines = lines_of(text);
    const std::size_t i = below(random, lines.size()), j = below(random, lines.size());
    const std::size_t what = below(random, 100);
    if (what == 0)
        swell(lines, i, most - std::min(most, text.size()));
    else if (what < 30)
        lines.erase(lines.begin() + std::ptrdiff_t(i));
    else if (what < 60)
        lines.insert(lines.begin() + std::ptrdiff_t(i), std::string(lines[j]));
    else if (what < 80)
        std::swap(lines[i], lines[j]);
    else
        lines[i] = mutated_bytes(lines[i], random);
    return joined(lines);
}

}  // namespace burl::fuzz
