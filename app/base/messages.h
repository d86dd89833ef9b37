#pragma once
// Messages for people: printed lines, and the word that somebody may have meant. Text from
// somebody's file cannot send commands to the terminal that shows it.
#include <span>
#include <string>
#include <string_view>

namespace burl {

/// The text with everything that terminals obey made visible: control characters (U+0000 to U+001F,
/// U+007F to U+009F) and bytes that are not UTF-8 become \x1b and the like. All other UTF-8 stays.
std::string printable(std::string_view text);

/// Prints a printable() line, without its middle beyond 1200 bytes, to stdout and flushes it, so
/// that readers see it at once. Throws std::system_error where it cannot be written.
void print_line(std::string_view line);

/// Prints a line to stderr as print_line() does; a stderr that cannot be written to is ignored.
void warn(std::string_view sentence);

/// Shows a printable() line below all messages on stderr, a terminal, in place of the last one, as
/// far as it is wide; messages come above it. Empty: no line.
void show_status(std::string_view line);

/// Joins names as "a.mtl, a.obj and a.png"; of many only the first, and the number of the others.
std::string names_together(std::span<const std::string> names);

/// The candidate with the smallest edit distance to `word`, as a view of its text; empty when there
/// is none that shares more than it lacks.
std::string_view nearest_word(std::string_view word, std::span<const std::string_view> candidates);
std::string_view nearest_word(std::string_view word, std::span<const std::string> candidates);

}  // namespace burl
