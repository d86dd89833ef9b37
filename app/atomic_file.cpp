// POSIX calls rather than iostreams: each one's failure is seen, with its reason.
#include "app/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "atlas/error.h"

namespace burl {
namespace {

constexpr std::size_t buffer_size = 1u << 18;

Error write_error(const std::string& target, int code) {
    return Error(ExitCode::io, fmt::format("{}: cannot be written: {}", target,
                                           std::generic_category().message(code)));
}

/// The file a chain of symbolic links ends at, existing or not.
std::string follow_links(const std::string& target) {
    std::filesystem::path path = target;
    std::error_code ignored;
    for (int depth = 0; depth < 40 && std::filesystem::is_symlink(path, ignored); ++depth) {
        const std::filesystem::path next = std::filesystem::read_symlink(path, ignored);
        if (ignored) break;
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return path.string();
}

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string temporary_name(const std::string& path, int attempt) {
    const std::filesystem::path p = path;
    std::string name = p.filename().string().substr(0, 200);  // names end at 255 bytes
    return (p.parent_path() / fmt::format(".{}.{}-{}.burl-tmp", name, ::getpid(), attempt))
        .string();
}

std::string handle_path(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

/// -1 where the file system has no nameless files, or /proc is missing to name them later.
int open_nameless(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor < 0 || ::access(handle_path(descriptor).c_str(), F_OK) == 0) return descriptor;
    ::close(descriptor);
    return -1;
}

}  // namespace

AtomicFile::AtomicFile(const std::string& target, Temporary kind)
    : target_(target), real_path_(follow_links(target)) {
    struct stat status {};
    replaces_ = ::stat(real_path_.c_str(), &status) == 0;
    if (replaces_ && S_ISDIR(status.st_mode)) throw write_error(target_, EISDIR);
    if (replaces_ && !S_ISREG(status.st_mode)) {
        throw Error(ExitCode::io, fmt::format("{}: is not a regular file", target_));
    }
    if (kind == Temporary::nameless) descriptor_ = open_nameless(folder_of(real_path_));
    if (descriptor_ < 0) take_name();
    if (descriptor_ < 0) throw write_error(target_, errno);
    if (replaces_) ::fchmod(descriptor_, status.st_mode & 07777);
    buffer_.reserve(buffer_size);
}

AtomicFile::~AtomicFile() {
    discard();
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)),
      real_path_(std::move(other.real_path_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      replaces_(other.replaces_),
      buffer_(std::move(other.buffer_)) {}

void AtomicFile::discard() noexcept {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
}

/// Gives the nameless file a temporary name, or opens a new named one when there is none. On
/// failure leaves errno and an empty name.
void AtomicFile::take_name() {
    const std::string handle = handle_path(descriptor_);
    const bool nameless = descriptor_ >= 0;
    for (int attempt = 0; attempt < 1000; ++attempt) {
        const std::string name = temporary_name(real_path_, attempt);
        int result = 0;
        if (nameless) {
            result = ::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW);
        } else {
            result = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
            descriptor_ = result;
        }
        if (result >= 0) {
            temporary_ = name;
            return;
        }
        if (errno != EEXIST) return;
    }
}

/// Calls write_some(rest) until nothing is left.
template <class WriteSome>
void AtomicFile::write_whole(std::span<const std::uint8_t> bytes, const WriteSome& write_some) {
    while (!bytes.empty()) {
        const ssize_t written = write_some(bytes);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) throw write_error(target_, written < 0 ? errno : ENOSPC);
        bytes = bytes.subspan(std::size_t(written));
    }
}

void AtomicFile::write_through(std::span<const std::uint8_t> bytes) {
    write_whole(bytes, [&](std::span<const std::uint8_t> rest) {
        return ::write(descriptor_, rest.data(), rest.size());
    });
}

void AtomicFile::flush() {
    write_through(buffer_);
    buffer_.clear();
}

void AtomicFile::overwrite(std::uint64_t position, std::span<const std::uint8_t> bytes) {
    flush();
    const std::uint8_t* first = bytes.data();
    write_whole(bytes, [&](std::span<const std::uint8_t> rest) {
        return ::pwrite(descriptor_, rest.data(), rest.size(),
                        off_t(position) + (rest.data() - first));
    });
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
    if (buffer_.size() + bytes.size() > buffer_size) flush();
    if (bytes.size() >= buffer_size) {
        write_through(bytes);
    } else {
        buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    }
}

void AtomicFile::write(std::string_view text) {
    write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void AtomicFile::finish() {
    if (descriptor_ < 0) return;
    flush();
    // Some special file systems cannot sync; that is no loss of data.
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) {
        throw write_error(target_, errno);
    }
    if (temporary_.empty()) take_name();
    if (temporary_.empty()) throw write_error(target_, errno);
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) {
        throw write_error(target_, errno);
    }
}

void AtomicFile::commit() {
    finish();
    if (std::rename(temporary_.c_str(), real_path_.c_str()) != 0) throw write_error(target_, errno);
    temporary_.clear();
}

ByteSink sink_of(AtomicFile& file) {
    return [&file](std::span<const std::uint8_t> bytes) { file.write(bytes); };
}

void commit_together(std::span<AtomicFile> files) {
    for (AtomicFile& file : files) file.finish();
    for (std::size_t i = 0; i < files.size(); ++i) {
        try {
            files[i].commit();
        } catch (...) {
            for (std::size_t j = 0; j < i; ++j) {
                if (!files[j].replaces_) ::unlink(files[j].real_path_.c_str());
            }
            throw;
        }
    }
}

void write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
}

void write_file(const std::string& path, std::string_view text) {
    write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace burl
