// POSIX calls rather than iostreams: every call reports its failure and the reason.
#include "app/base/atomic_file.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/base/real_path.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

constexpr std::size_t buffer_size = 1u << 18;

Error write_error(const std::string& target, int code) {
    return Error(ExitCode::io, fmt::format("{}: cannot be written: {}", target,
                                           std::generic_category().message(code)));
}

std::string folder_of(const std::string& path) {
    const std::string folder = std::filesystem::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

std::string temporary_name(const std::string& path, int attempt) {
    const std::filesystem::path p = path;
    // File systems limit names to 255 bytes.
    std::string name = p.filename().string().substr(0, 200);
    return (p.parent_path() / fmt::format(".{}.{}.burl-tmp", name, attempt)).string();
}

/// Locks the file for as long as it is being written; the lock goes when the process ends.
void lock_for_this_run(int descriptor) {
    // A run that takes this file for a left-over may hold the lock for a moment; was_removed() then
    // tells whether it removed the file. Without locks no run removes left-overs.
    while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
    }
}

/// Removes the temporary file of a run that was killed.
void remove_left_over(const std::string& name) {
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return;
    struct stat locked {
    }, named{};
    // The name may have been given to another file before the lock was taken.
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &locked) == 0 &&
        ::lstat(name.c_str(), &named) == 0 && locked.st_ino == named.st_ino &&
        S_ISREG(named.st_mode))
        ::unlink(name.c_str());
    ::close(descriptor);
}

/// Whether another run took the file for a left-over and removed it before it was locked.
bool was_removed(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 && status.st_nlink == 0;
}

std::string handle_path(int descriptor) {
    return fmt::format("/proc/self/fd/{}", descriptor);
}

/// A descriptor of a nameless file; -1 where the file system has none, or where /proc, which names
/// it later, is missing.
int open_nameless(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (descriptor < 0 || ::access(handle_path(descriptor).c_str(), F_OK) == 0) return descriptor;
    ::close(descriptor);
    return -1;
}

/// The names of this process's temporary files that exist. The mutex is held while names are given
/// or removed.
struct TemporaryNames {
    std::mutex mutex;
    std::set<std::string> names;
};

/// The process's only list; never destroyed, since a signal may arrive during exit.
TemporaryNames& temporary_names() {
    static auto* const all = new TemporaryNames;
    return *all;
}

/// Ends the program by the signal's default action once all temporary files are removed. The mutex
/// stays locked, so that no file gets a name any more.
[[noreturn]] void end_by_signal(int signal, const sigset_t& signals) {
    temporary_names().mutex.lock();
    for (const std::string& name : temporary_names().names) ::unlink(name.c_str());
    std::signal(signal, SIG_DFL);
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    std::raise(signal);
    std::_Exit(128 + signal);  // the first process of a container ignores what it does not handle
}

CommittedFile state_from(const std::string& path, const struct stat& status) {
    return {path, std::uint64_t(status.st_size), status.st_ino, status.st_mtim.tv_sec,
            status.st_mtim.tv_nsec};
}

}  // namespace

std::optional<CommittedFile> file_there(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    return state_from(path, status);
}

AtomicFile::AtomicFile(const std::string& target, Temporary kind)
    : target_(target), real_path_(follow_links(target)) {
    struct stat status {};
    replaces_ = ::stat(real_path_.c_str(), &status) == 0;
    if (!replaces_ && errno == ELOOP) throw write_error(target_, ELOOP);
    if (replaces_ && S_ISDIR(status.st_mode)) throw write_error(target_, EISDIR);
    if (replaces_ && !S_ISREG(status.st_mode)) {
        throw Error(ExitCode::io, fmt::format("{}: is not a regular file", target_));
    }
    if (kind == Temporary::nameless) descriptor_ = open_nameless(folder_of(real_path_));
    if (descriptor_ >= 0) {
        lock_for_this_run(descriptor_);
    } else {
        const std::scoped_lock lock(temporary_names().mutex);
        take_name();
    }
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
      finished_(other.finished_),
      buffer_(std::move(other.buffer_)) {}

void AtomicFile::discard() noexcept {
    if (descriptor_ >= 0) ::close(descriptor_);
    descriptor_ = -1;
    if (temporary_.empty()) return;
    const std::scoped_lock lock(temporary_names().mutex);
    ::unlink(temporary_.c_str());
    temporary_names().names.erase(temporary_);
    temporary_.clear();
}

/// Gives the nameless file a temporary name, or opens a new named one when there is none.
void AtomicFile::take_name() {
    const std::string handle = handle_path(descriptor_);
    const bool nameless = descriptor_ >= 0;
    int result = -1;
    for (int attempt = 0; attempt < 1000; ++attempt) {
        const std::string name = temporary_name(real_path_, attempt);
        remove_left_over(name);
        if (nameless) {
            result = ::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW);
        } else {
            result = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
            descriptor_ = result;
            if (result >= 0) lock_for_this_run(descriptor_);
        }
        if (result < 0 && errno == EEXIST) continue;
        if (result < 0) break;
        if (was_removed(descriptor_)) {
            ::close(std::exchange(descriptor_, -1));
            continue;
        }
        temporary_ = name;
        temporary_names().names.insert(name);
        return;
    }
    throw write_error(target_, errno);
}

/// Calls write_some(rest), which returns the number of bytes written, until no bytes are left.
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
    if (finished_) return;
    flush();
    // Some special file systems cannot sync; that is no loss of data.
    if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) {
        throw write_error(target_, errno);
    }
    finished_ = true;
}

/// Gives a nameless file a temporary name where the target exists: only rename() replaces a file,
/// and it needs a name.
void AtomicFile::name_beside_old() {
    remove_left_over(temporary_name(real_path_, 0));
    if (temporary_.empty() && ::access(real_path_.c_str(), F_OK) == 0) take_name();
}

/// Gives the finished file the target's name.
void AtomicFile::take_place() {
    if (temporary_.empty()) {
        if (::linkat(AT_FDCWD, handle_path(descriptor_).c_str(), AT_FDCWD, real_path_.c_str(),
                     AT_SYMLINK_FOLLOW) == 0)
            return;
        if (errno != EEXIST) throw write_error(target_, errno);
        take_name();  // another process created the target meanwhile
    }
    if (std::rename(temporary_.c_str(), real_path_.c_str()) != 0) throw write_error(target_, errno);
    temporary_names().names.erase(std::exchange(temporary_, {}));
}

CommittedFile AtomicFile::committed() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) throw write_error(target_, errno);
    return state_from(target_, status);
}

CommittedFile AtomicFile::commit() {
    return commit_together({this, 1}).front();
}

ByteSink sink_of(AtomicFile& file) {
    return [&file](std::span<const std::uint8_t> bytes) { file.write(bytes); };
}

std::vector<CommittedFile> commit_together(std::span<AtomicFile> files) {
    for (AtomicFile& file : files) file.finish();
    std::vector<CommittedFile> committed;
    for (const AtomicFile& file : files) committed.push_back(file.committed());
    const std::scoped_lock lock(temporary_names().mutex);
    for (AtomicFile& file : files) file.name_beside_old();
    for (std::size_t i = 0; i < files.size(); ++i) {
        try {
            files[i].take_place();
        } catch (...) {
            for (std::size_t j = 0; j < i; ++j) {
                if (!files[j].replaces_) ::unlink(files[j].real_path_.c_str());
            }
            throw;
        }
    }
    return committed;
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && std::filesystem::is_directory(folder)) return;
    throw Error(ExitCode::io, fmt::format("{}: cannot make this folder: {}", folder,
                                          error ? error.message() : "it is a file"));
}

void clean_up_on_signals() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction now {};
        ::sigaction(signal, nullptr, &now);
        if (now.sa_handler == SIG_DFL) ::sigaddset(&signals, signal);
    }
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    try {
        std::thread([signals] {
            int signal = 0;
            while (::sigwait(&signals, &signal) != 0) {
            }
            end_by_signal(signal, signals);
        }).detach();
    } catch (const std::system_error&) {  // without a thread signals end the program at once
        ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    }
}

CommittedFile write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
    AtomicFile file(path);
    file.write(bytes);
    return file.commit();
}

CommittedFile write_file(const std::string& path, std::string_view text) {
    return write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace burl
