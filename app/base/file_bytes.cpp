// Files are read by POSIX calls: unlike iostreams they give the reason of a failure and refuse
// folders.
#include "app/base/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <span>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "atlas/base/error.h"

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

/// The largest content read from a pipe, in bytes.
constexpr std::uint64_t most_of_pipe = 1ull << 28;

enum class Readable { regular, regular_or_pipe };

/// Throws Error(io) unless the file is of a kind that may be read. Called before open() as well,
/// since opening a pipe may wait for its writer.
void refuse_unreadable(const std::string& path, const struct stat& status, Readable kind) {
    if (S_ISDIR(status.st_mode))
        throw Error(ExitCode::io, fmt::format("{}: cannot be read: it is a folder", path));
    if (S_ISREG(status.st_mode)) return;
    if (kind == Readable::regular_or_pipe && S_ISFIFO(status.st_mode)) return;
    throw Error(ExitCode::io, fmt::format("{}: cannot be read: it is not a regular file", path));
}

/// An open file with its size in bytes, 0 where it is a pipe.
struct Opened {
    Descriptor file{-1};
    std::size_t size = 0;

    Opened(const std::string& path, Readable kind) {
        struct stat status {};
        if (::stat(path.c_str(), &status) != 0) throw read_error(path, errno);
        refuse_unreadable(path, status, kind);
        const int waits = S_ISFIFO(status.st_mode) ? 0 : O_NONBLOCK;
        file.fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | waits);
        if (file.fd < 0 || ::fstat(file.fd, &status) != 0) throw read_error(path, errno);
        refuse_unreadable(path, status, kind);
        if (S_ISREG(status.st_mode)) size = std::size_t(status.st_size);
    }
};

/// Reads into `bytes` and returns the number of bytes read; 0 at the end of the file.
std::size_t read_some(const std::string& path, const Opened& opened,
                      std::span<std::uint8_t> bytes) {
    for (;;) {
        const ssize_t got = ::read(opened.file.fd, bytes.data(), bytes.size());
        if (got >= 0) return std::size_t(got);
        if (errno != EINTR) throw read_error(path, errno);
    }
}

/// The content up to the end of the file, which may grow while it is read.
std::vector<std::uint8_t> read_to_end(const std::string& path, const Opened& opened,
                                      std::uint64_t most) {
    const auto refuse = [&](std::size_t size) {
        if (size > most)
            throw Error(ExitCode::io,
                        fmt::format("{}: cannot be read: it has more than {} MiB, the most that is "
                                    "read of such a file",
                                    path, most >> 20));
    };
    refuse(opened.size);
    // One byte more, so that the last read can return 0.
    std::vector<std::uint8_t> bytes(opened.size + 1);
    std::size_t filled = 0;
    for (;;) {
        if (filled == bytes.size()) bytes.resize(filled + filled / 8 + 4096);
        const std::size_t got = read_some(path, opened, std::span(bytes).subspan(filled));
        if (got == 0) break;
        refuse(filled += got);
    }
    bytes.resize(filled);
    return bytes;
}

}  // namespace

void read_file_pieces(const std::string& path, const ByteSink& sink) {
    const Opened opened(path, Readable::regular);
    std::vector<std::uint8_t> piece(1u << 18);
    while (const std::size_t got = read_some(path, opened, piece))
        sink(std::span(piece).first(got));
}

std::vector<std::uint8_t> read_file_bytes(const std::string& path) {
    const Opened opened(path, Readable::regular_or_pipe);
    return read_to_end(path, opened, std::max<std::uint64_t>(opened.size, most_of_pipe));
}

std::vector<std::uint8_t> read_regular_file(const std::string& path, std::uint64_t most) {
    return read_to_end(path, Opened(path, Readable::regular), most);
}

std::vector<std::uint8_t> read_file_head(const std::string& path, std::size_t bytes) {
    const Opened opened(path, Readable::regular);
    std::vector<std::uint8_t> head(bytes);
    head.resize(read_some(path, opened, head));
    return head;
}

}  // namespace burl
