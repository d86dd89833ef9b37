#pragma once
// JSON as people write it: errors name file and line, a key given twice is an error, and what we
// print keeps short arrays on one line.
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace burl {

/// Keeps keys in the order of the file.
using Json = nlohmann::ordered_json;

/// Throws Error(invalid_file) "origin:line: ...".
Json parse_json_text(const std::string& text, const std::string& origin);

/// Two spaces of indentation; arrays without objects inside stay on one line. Ends with a newline.
std::string print_json(const Json& json);

/// One line; invalid UTF-8 is replaced, so this never throws.
std::string print_json_value(const Json& json);

}  // namespace burl
