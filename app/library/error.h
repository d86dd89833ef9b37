#pragma once
// The base of every header of the library: the namespace, what is exported, and the one
// exception. Programs write burl::Mesh; the names live in burl::library, apart from the inner ones.
#include <stdexcept>
#include <string>

/// Marks what the shared library exports.
#define BURL_API __attribute__((visibility("default")))

namespace burl::library {

/// The kind of an Error; the numbers are the exit codes of the program.
enum class ErrorKind : int {
    usage = 1,         ///< a wrong argument
    io = 2,            ///< a file or folder could not be read or written
    invalid_file = 3,  ///< a file or a recipe's text was read, but its content is wrong
    runtime = 4,       ///< any other failure
    unsupported = 5,   ///< valid, but beyond this build or machine
    stopped = 130,     ///< a progress callback asked to stop
};

/// The one exception of the library, besides std::bad_alloc: a kind with a sentence for people,
/// what(), in UTF-8. What a progress callback throws passes through as it is.
class BURL_API Error : public std::runtime_error {
  public:
    /// Takes the kind and one sentence.
    Error(ErrorKind kind, const std::string& sentence);
    ~Error() override;
    /// The kind of failure.
    ErrorKind kind() const noexcept { return kind_; }

  private:
    ErrorKind kind_;
};

}  // namespace burl::library

#ifndef BURL_BUILDS_LIBRARY
namespace burl {
using namespace library;
}
#endif
