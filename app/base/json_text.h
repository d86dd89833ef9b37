#pragma once
// JSON as people write it: errors name file and line, a key that occurs twice in an object is an
// error, and printed JSON keeps short arrays on one line.
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace burl {

/// A JSON value whose objects keep their keys in the order of the file.
using Json = nlohmann::ordered_json;

/// Parses a whole document; `origin` names it in errors. Throws Error(invalid_file) "origin:line:
/// ...".
Json parse_json_text(const std::string& text, const std::string& origin);

/// The value with two spaces of indentation per level; arrays of plain values stay on one line.
/// Ends with a newline.
std::string print_json(const Json& json);

/// The value on one line. Never throws: invalid UTF-8 is replaced.
std::string print_json_value(const Json& json);

}  // namespace burl
