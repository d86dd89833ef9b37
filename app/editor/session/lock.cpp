// The lock is flock()'s, which the kernel releases with the process; fcntl's locks would end when
// any descriptor of the file is closed.
#include "app/editor/session/lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace burl {

namespace {

/// Whether the path still leads to the open file, which its last holder may just have removed.
bool still_names(const std::string& path, int descriptor) {
    struct stat named {
    }, opened{};
    return ::stat(path.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 &&
           named.st_dev == opened.st_dev && named.st_ino == opened.st_ino;
}

}  // namespace

std::optional<EditLock> EditLock::take(const std::string& path) {
    constexpr int attempts = 10;
    for (int i = 0; i < attempts; ++i) {
        const int descriptor = ::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600);
        if (descriptor < 0) return {};
        const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
        if (locked && still_names(path, descriptor)) return EditLock(path, descriptor);
        ::close(descriptor);
        if (!locked) return {};
    }
    return {};
}

EditLock::EditLock(EditLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

EditLock& EditLock::operator=(EditLock&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    return *this;
}

EditLock::~EditLock() {
    if (descriptor_ < 0) return;
    ::unlink(path_.c_str());
    ::close(descriptor_);
}

}  // namespace burl
