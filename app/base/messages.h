#pragma once
// How lines for people are printed, so that a name or text from somebody's file cannot command the
// terminal it is shown on.
#include <string>
#include <string_view>

namespace burl {

/// The text with everything that terminals obey made visible: control characters (those after 0x7e
/// and U+0080 to U+009F among them) and bytes that are no UTF-8 become \x1b and the like. All other
/// UTF-8 stays.
std::string printable(std::string_view text);

/// A printable line on stdout, written at once: who reads it from a file or through a pipe sees it
/// when it is true. Throws std::system_error where it cannot be written.
void print_line(std::string_view line);

/// A printable line on stderr; a stderr that cannot be written to is no reason to stop.
void warn(std::string_view sentence);

}  // namespace burl
