#pragma once
// The one exception of the project. It is thrown only where something is read, parsed or written;
// the programs' mains (and the editor's load action) catch it, print the sentence on stderr and
// leave with its exit code.
#include <cstddef>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

namespace burl {

/// Exit codes of every program (docs/reference/usage.md lists them).
enum class ExitCode : int {
    ok = 0,
    usage = 1,         ///< wrong command line
    io = 2,            ///< a file or folder could not be read or written
    invalid_file = 3,  ///< a file was read but its content is wrong
    runtime = 4,       ///< any other failure
    unsupported = 5,   ///< valid, but beyond this build or machine
    difference = 7,    ///< `burl diff` found more than the tolerance
};

/// An exit code with a sentence for the user, what().
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& sentence) : std::runtime_error(sentence), code_(code) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

/// "file:line: message" with exit code invalid_file; line 0 leaves the number out (binary files).
inline Error invalid_file(const std::string& path, std::size_t line, const std::string& message) {
    return Error(ExitCode::invalid_file, line == 0 ? fmt::format("{}: {}", path, message)
                                                   : fmt::format("{}:{}: {}", path, line, message));
}

}  // namespace burl
