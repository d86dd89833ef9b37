// Reads by POSIX calls: unlike iostreams they say why something failed, and a folder is refused.
#include "app/file_bytes.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "atlas/error.h"

namespace burl {
namespace {

Error read_error(const std::string& path, int code) {
    return Error(ExitCode::io, fmt::format("{}: cannot be read: {}", path,
                                           std::generic_category().message(code)));
}

struct Descriptor {
    int fd;
    ~Descriptor() {
        if (fd >= 0) ::close(fd);
    }
};

}  // namespace

std::vector<std::uint8_t> read_file_bytes(const std::string& path) {
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
    struct stat status {};
    if (file.fd < 0 || ::fstat(file.fd, &status) != 0) throw read_error(path, errno);
    if (S_ISDIR(status.st_mode)) throw read_error(path, EISDIR);
    std::vector<std::uint8_t> bytes(S_ISREG(status.st_mode) ? std::size_t(status.st_size) : 0);
    std::size_t filled = 0;
    for (;;) {
        if (filled == bytes.size()) bytes.resize(filled + (filled == 0 ? 4096 : filled / 8 + 4096));
        const ssize_t got = ::read(file.fd, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw read_error(path, errno);
        if (got == 0) break;
        filled += std::size_t(got);
    }
    bytes.resize(filled);
    return bytes;
}

}  // namespace burl
