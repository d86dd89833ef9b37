#pragma once
// What a program does that the system gives no memory any more. Unwinding needs memory itself
// (destructors of JSON values, messages), and libraries ask for some where no exception may leave,
// so a program that has none left ends at once.
#include <exception>
#include <string>
#include <string_view>

namespace burl {

/// From now on the program ends in one sentence, with the exit code of "anything else that failed",
/// where not even small blocks of memory are left, or where no exception may say so; temporary
/// files are removed. A block that is too large for the system still is std::bad_alloc. `line` is
/// the sentence with its line feed, a literal.
void end_where_memory_ends(std::string_view line);

/// Returns the message of an exception; that of std::bad_alloc is "out of memory".
std::string words_of(const std::exception& problem);

}  // namespace burl
