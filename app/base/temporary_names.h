#pragma once
// The temporary files of this process that have a name, so that a signal or the end of memory
// removes them.
#include <mutex>
#include <set>
#include <string>

namespace burl {

/// Holds the list of names while files get or lose theirs; signals that end the program wait for
/// it.
class TemporaryNames {
  public:
    TemporaryNames();
    ~TemporaryNames();
    TemporaryNames(const TemporaryNames&) = delete;
    TemporaryNames& operator=(const TemporaryNames&) = delete;

    void add(const std::string& name);
    /// Frees memory and needs none.
    void remove(const std::string& name);

  private:
    std::unique_lock<std::mutex> lock_;
};

/// Removes all temporary files that have a name; from then on no file gets or loses one. Needs no
/// memory. May be called by a thread that holds a TemporaryNames.
void remove_temporary_files_for_good();

}  // namespace burl
