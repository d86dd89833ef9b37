#pragma once
// A lock file that one running program at a time can hold. The system releases it when the program
// ends, however it ends.
#include <optional>
#include <string>
#include <utility>

namespace burl {

/// A lock on a file, held until destruction.
class EditLock {
  public:
    /// Creates the file `path` and locks it; empty where another program holds it or the file
    /// cannot be created.
    static std::optional<EditLock> take(const std::string& path);
    EditLock(EditLock&& other) noexcept;
    EditLock& operator=(EditLock&& other) noexcept;
    /// Removes the file and releases the lock.
    ~EditLock();

  private:
    EditLock(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

    std::string path_;
    int descriptor_ = -1;
};

}  // namespace burl
