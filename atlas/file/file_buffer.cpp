// Reads whole files with the plain system calls: one allocation, no initialisation, and the
// system's own reason in the message when it fails.
#include "atlas/file/file_buffer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "atlas/base/error.h"

namespace burl {
namespace {

[[noreturn]] void fail(const std::string& path, int error_number) {
    throw Error(ExitCode::io, fmt::format("cannot read {}: {}", path,
                                          std::system_category().message(error_number)));
}

/// Closes a file descriptor at the end of its scope.
struct Descriptor {
    int number;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

/// The size of an open file. Throws Error(io) unless it is a regular one.
std::size_t size_of(const Descriptor& file, const std::string& path) {
    if (file.number < 0) fail(path, errno);
    struct stat status {};
    if (::fstat(file.number, &status) != 0) fail(path, errno);
    if (S_ISDIR(status.st_mode))
        throw Error(ExitCode::io, fmt::format("cannot read {}: it is a folder, not a file", path));
    if (!S_ISREG(status.st_mode))
        throw Error(ExitCode::io, fmt::format("cannot read {}: it is not a regular file", path));
    return static_cast<std::size_t>(status.st_size);
}

/// Opens a file; a pipe without waiting for a writer.
int open_to_read(const std::string& path) {
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

}  // namespace

void check_file(const std::string& path) {
    size_of(Descriptor{open_to_read(path)}, path);
}

FileBuffer read_file(const std::string& path, NamedFiles named) {
    const Descriptor file{open_to_read(path)};
    const std::size_t size = size_of(file, path);
    FileBuffer buffer;
    buffer.path = path;
    buffer.named = named;
    buffer.bytes = std::make_unique_for_overwrite<char[]>(std::max<std::size_t>(size, 1));
    while (buffer.size < size) {
        const ssize_t got =
            ::read(file.number, buffer.bytes.get() + buffer.size, size - buffer.size);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) fail(path, errno);
        if (got == 0) break;  // the file became shorter meanwhile
        buffer.size += static_cast<std::size_t>(got);
    }
    return buffer;
}

FileBuffer buffer_from(std::string_view content, std::string path) {
    FileBuffer buffer;
    buffer.path = std::move(path);
    buffer.size = content.size();
    buffer.bytes = std::make_unique_for_overwrite<char[]>(std::max<std::size_t>(content.size(), 1));
    if (!content.empty()) std::memcpy(buffer.bytes.get(), content.data(), content.size());
    return buffer;
}

}  // namespace burl
