#include "atlas/read/obj_libraries.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_set>

#include "atlas/file/text_scanner.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view library_blanks = " \t\v\f\r";

/// Takes the next word, and the blanks round it, from the text.
std::string_view take_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(library_blanks), text.size()));
    const std::string_view word =
        text.substr(0, std::min(text.find_first_of(library_blanks), text.size()));
    text.remove_prefix(word.size());
    text.remove_prefix(std::min(text.find_first_not_of(library_blanks), text.size()));
    return word;
}

bool is_library_number(std::string_view word) {
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto [stop, failure] = std::from_chars(word.data(), end, value);
    return failure == std::errc() && stop == end;
}

/// The name behind the options of a picture: -o, -s and -t take up to three numbers, the pair of
/// -mm is two, and every other option takes one word.
std::string_view without_options(std::string_view text) {
    const std::string_view last =
        text.substr(std::min(text.find_last_of(library_blanks) + 1, text.size()));
    while (text.starts_with('-')) {
        const std::string_view option = take_word(text);
        const bool numbers = option == "-o" || option == "-s" || option == "-t";
        for (int k = option == "-mm" ? 2 : 1; k > 0 && !numbers; --k) take_word(text);
        for (int k = 0; k < 3 && numbers; ++k) {
            std::string_view ahead = text;
            if (!is_library_number(take_word(ahead))) break;
            text = ahead;
        }
    }
    return text.empty() ? last : text;
}

std::string in_small_letters(std::string_view word) {
    std::string small(word);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return small;
}

bool names_picture(std::string_view keyword) {
    static constexpr std::array<std::string_view, 5> others{"norm", "bump", "disp", "decal",
                                                            "refl"};
    const std::string word = in_small_letters(keyword);
    return word.starts_with("map_") || std::ranges::find(others, word) != others.end();
}

}  // namespace

std::vector<std::string> libraries_of(std::string_view line, const fs::path& folder) {
    std::error_code ignored;
    if (!line.empty() && fs::exists(folder / line, ignored)) return {std::string(line)};
    std::vector<std::string> words;
    while (!line.empty())
        if (const std::string_view word = take_word(line); !word.empty()) words.emplace_back(word);
    return words;
}

std::vector<std::string> libraries_of(const FileBuffer& obj) {
    const fs::path folder = fs::path(obj.path).parent_path();
    std::vector<std::string> libraries;
    std::unordered_set<std::string> known;
    TextScanner in(obj, true, text_begin(obj));  // as the mesh is read
    do {
        if (in.word() != "mtllib") continue;
        for (std::string& name : libraries_of(in.rest_of_line(), folder))
            if (known.insert(name).second) libraries.push_back(std::move(name));
    } while (in.next_line());
    return libraries;
}

std::vector<std::string> pictures_of_library(std::string_view text) {
    std::vector<std::string> pictures;
    for_each_library_line(text, [&](std::string_view keyword, std::string_view rest) {
        if (keyword == "#" && rest.starts_with(packed_comment))
            pictures.emplace_back(rest.substr(packed_comment.size()));
        else if (!rest.empty() && names_picture(keyword))
            pictures.emplace_back(without_options(rest));
        else
            return;
        if (std::string name = pictures.back(); std::ranges::count(name, '\\') > 0) {
            std::ranges::replace(name, '\\', '/');
            pictures.push_back(std::move(name));
        }
    });
    return pictures;
}

}  // namespace burl
