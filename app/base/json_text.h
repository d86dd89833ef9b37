#pragma once
// JSON as people write it: errors name file and line, a key that occurs twice in an object is an
// error, and printed JSON keeps short arrays on one line.
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace burl {

/// A JSON value whose objects keep their keys in the order of the file.
using Json = nlohmann::ordered_json;

/// Objects and arrays within each other that a document may have: far more than recipes need, few
/// enough to be copied and printed by functions that call themselves.
inline constexpr int max_json_depth = 1000;

/// Parses a whole document; `origin` names it in errors. Throws Error(invalid_file) "origin:line:
/// ..." also for a document deeper than max_json_depth, and for texts with U+0000.
Json parse_json_text(const std::string& text, const std::string& origin);

/// The value that the text spells; discarded if it is not JSON or deeper than max_json_depth.
Json parse_json_value(const std::string& text);

/// The value with two spaces of indentation per level; arrays of plain values stay on one line.
/// Ends with a newline.
std::string print_json(const Json& json);

/// The value on one line. Never throws: invalid UTF-8 is replaced.
std::string print_json_value(const Json& json);

}  // namespace burl
