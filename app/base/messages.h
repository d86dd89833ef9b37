#pragma once
// Lines printed for people. Text from somebody's file cannot send commands to the terminal that
// shows it.
#include <string>
#include <string_view>

namespace burl {

/// The text with everything that terminals obey made visible: control characters (U+0000 to U+001F,
/// U+007F to U+009F) and bytes that are not UTF-8 become \x1b and the like. All other UTF-8 stays.
std::string printable(std::string_view text);

/// Prints a printable() line to stdout and flushes it, so that readers of a file or pipe see it at
/// once. Throws std::system_error where it cannot be written.
void print_line(std::string_view line);

/// Prints a printable() line to stderr; a stderr that cannot be written to is ignored.
void warn(std::string_view sentence);

}  // namespace burl
