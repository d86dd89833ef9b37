#pragma once
// A name that one running program at a time has. The system lets go of it when the program ends,
// however that comes about.
#include <optional>
#include <string>
#include <utility>

namespace burl {

class EditLock {
  public:
    /// Makes the file `path` and locks it; empty where another program has it, or where it cannot
    /// be made.
    static std::optional<EditLock> take(const std::string& path);
    EditLock(EditLock&& other) noexcept;
    EditLock& operator=(EditLock&& other) noexcept;
    /// The file is gone then.
    ~EditLock();

  private:
    EditLock(std::string path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

    std::string path_;
    int descriptor_ = -1;
};

}  // namespace burl
