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

/// Opens the file; its size is 0 where it is none on a disk.
struct Opened {
    Descriptor file;
    std::size_t size = 0;

    explicit Opened(const std::string& path) : file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)} {
        struct stat status {};
        if (file.fd < 0 || ::fstat(file.fd, &status) != 0) throw read_error(path, errno);
        if (S_ISDIR(status.st_mode)) throw read_error(path, EISDIR);
        if (S_ISREG(status.st_mode)) size = std::size_t(status.st_size);
    }
};

/// How many bytes came; 0: the file's end.
std::size_t read_some(const std::string& path, const Opened& opened,
                      std::span<std::uint8_t> bytes) {
    for (;;) {
        const ssize_t got = ::read(opened.file.fd, bytes.data(), bytes.size());
        if (got >= 0) return std::size_t(got);
        if (errno != EINTR) throw read_error(path, errno);
    }
}

}  // namespace

void read_file_pieces(const std::string& path, const ByteSink& sink) {
    const Opened opened(path);
    std::vector<std::uint8_t> piece(1u << 18);
    while (const std::size_t got = read_some(path, opened, piece))
        sink(std::span(piece).first(got));
}

std::vector<std::uint8_t> read_file_bytes(const std::string& path) {
    const Opened opened(path);
    std::vector<std::uint8_t> bytes(opened.size);
    std::size_t filled = 0;
    for (;;) {
        if (filled == bytes.size()) bytes.resize(filled + (filled == 0 ? 4096 : filled / 8 + 4096));
        const std::size_t got = read_some(path, opened, std::span(bytes).subspan(filled));
        if (got == 0) break;
        filled += got;
    }
    bytes.resize(filled);
    return bytes;
}

}  // namespace burl
