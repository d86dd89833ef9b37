#pragma once
// The files that a Wavefront OBJ names: its material libraries, and their pictures. Materials are
// no part of a mesh; what follows is for those who draw them, keep them, or must not replace them.
#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "atlas/file/file_buffer.h"

namespace burl {

/// The names of libraries in what follows mtllib: one with spaces where there is such a file in the
/// folder, else one per word.
std::vector<std::string> libraries_of(std::string_view line, const std::filesystem::path& folder);

/// The names of all libraries of an OBJ, each once, in the order in which they are named.
std::vector<std::string> libraries_of(const FileBuffer& obj);

/// Calls visit(keyword, rest of the line) for every line of a library, comments included; neither
/// has blanks at its ends.
template <class Visit>
void for_each_library_line(std::string_view text, Visit visit) {
    constexpr std::string_view blanks = " \t\v\f\r";
    const auto trimmed = [&](std::string_view line) {
        const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
        return line.substr(begin, line.find_last_not_of(blanks) + 1 - begin);
    };
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    while (!text.empty()) {
        const std::string_view line = trimmed(text.substr(0, text.find('\n')));
        const std::size_t space = std::min(line.find_first_of(blanks), line.size());
        visit(line.substr(0, space), trimmed(line.substr(space)));
        text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    }
}

/// The comment by which Burl's libraries name a picture that no keyword of MTL could.
inline constexpr std::string_view packed_comment = "roughness and metallic: ";

/// The names of the pictures of a library, without the options before them (-s 2 2 2), some more
/// than once; one with `\` also with `/`, as many programs read it. They lie in the library's
/// folder, or in that of the OBJ.
std::vector<std::string> pictures_of_library(std::string_view text);

}  // namespace burl
