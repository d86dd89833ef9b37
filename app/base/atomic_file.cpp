// POSIX calls rather than iostreams: every call reports its failure and the reason.
#include "app/base/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "app/base/temporary_names.h"
#include "atlas/base/error.h"
#include "atlas/base/real_path.h"

namespace burl {
namespace {

constexpr std::size_t buffer_size = 1u << 18;
/// Left-overs of one name that are looked for at a time.
constexpr int most_left_overs = 16;

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

/// Removes the temporary file of a run that was killed; whether there is a file of that name.
bool remove_left_over(const std::string& name) {
    const int descriptor = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return false;
    struct stat locked {
    }, named{};
    // The name may have been given to another file before the lock was taken.
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &locked) == 0 &&
        ::lstat(name.c_str(), &named) == 0 && locked.st_ino == named.st_ino &&
        S_ISREG(named.st_mode))
        ::unlink(name.c_str());
    ::close(descriptor);
    return true;
}

/// The turn of one of several runs that give names in a folder at a time: their groups of files do
/// not mix. Nobody waits longer than two seconds, for others may lock folders, too.
class Turn {
  public:
    explicit Turn(const std::string& folder)
        : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        for (int i = 0; i < 1000 && folder_ >= 0 && ::flock(folder_, LOCK_EX | LOCK_NB) != 0; ++i)
            ::usleep(2000);
    }
    ~Turn() {
        if (folder_ >= 0) ::close(folder_);
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

  private:
    int folder_;
};

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
    const bool replaces = ::stat(real_path_.c_str(), &status) == 0;
    if (!replaces && errno == ELOOP) throw write_error(target_, ELOOP);
    if (replaces && S_ISDIR(status.st_mode)) throw write_error(target_, EISDIR);
    if (replaces && !S_ISREG(status.st_mode)) {
        throw Error(ExitCode::io, fmt::format("{}: is not a regular file", target_));
    }
    if (kind == Temporary::nameless) descriptor_ = open_nameless(folder_of(real_path_));
    if (descriptor_ >= 0) {
        lock_for_this_run(descriptor_);
    } else {
        TemporaryNames names;
        take_name(names);
    }
    if (replaces) ::fchmod(descriptor_, status.st_mode & 07777);
    buffer_.reserve(buffer_size);
}

AtomicFile::~AtomicFile() {
    discard();
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : target_(std::move(other.target_)),
      real_path_(std::move(other.real_path_)),
      temporary_(std::exchange(other.temporary_, {})),
      handle_(std::move(other.handle_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      old_(std::exchange(other.old_, -1)),
      place_(other.place_),
      finished_(other.finished_),
      buffer_(std::move(other.buffer_)) {}

void AtomicFile::discard() noexcept {
    for (int* const open : {&descriptor_, &old_})
        if (*open >= 0) ::close(std::exchange(*open, -1));
    if (temporary_.empty()) return;
    TemporaryNames names;
    remove_temporary(names);
}

/// Gives the nameless file a temporary name, or opens a new named one when there is none.
void AtomicFile::take_name(TemporaryNames& names) {
    const std::string handle = handle_path(descriptor_);
    const bool nameless = descriptor_ >= 0;
    int error = EEXIST;
    for (int attempt = 0; attempt < 1000 && error == EEXIST; ++attempt) {
        temporary_ = temporary_name(real_path_, attempt);
        remove_left_over(temporary_);
        names.add(temporary_);  // before there is such a file: whatever ends the program removes it
        int result = -1;
        if (nameless) {
            result =
                ::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW);
        } else {
            result = ::open(temporary_.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
            descriptor_ = result;
            if (result >= 0) lock_for_this_run(descriptor_);
        }
        error = result < 0 ? errno : 0;
        if (error == 0 && was_removed(descriptor_)) {
            ::close(std::exchange(descriptor_, -1));
            error = EEXIST;
        }
        if (error == 0) return;
        names.remove(temporary_);
        temporary_.clear();
    }
    throw write_error(target_, error);
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
void AtomicFile::name_beside_old(TemporaryNames& names) {
    for (int attempt = 0; attempt < most_left_overs; ++attempt)
        remove_left_over(temporary_name(real_path_, attempt));
    handle_ = handle_path(descriptor_);
    if (temporary_.empty() && ::access(real_path_.c_str(), F_OK) == 0) take_name(names);
}

/// Exchanges the finished file with the target, so that it can be given back; whether that was
/// possible. The old file is locked, for another run would take it for a left-over.
bool AtomicFile::exchange() {
    old_ = ::open(real_path_.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat status {};
    const bool is_file = old_ >= 0 && ::fstat(old_, &status) == 0 && S_ISREG(status.st_mode);
    if (is_file && ::flock(old_, LOCK_EX | LOCK_NB) == 0 &&
        ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, real_path_.c_str(), RENAME_EXCHANGE) ==
            0)
        return true;
    if (old_ >= 0) ::close(std::exchange(old_, -1));
    return false;
}

/// Gives the finished file the target's name. `one_of_many` says that it may have to be given back.
/// Needs no memory but where another process makes the target at this moment.
void AtomicFile::take_place(TemporaryNames& names, bool one_of_many) {
    if (temporary_.empty()) {
        if (::linkat(AT_FDCWD, handle_.c_str(), AT_FDCWD, real_path_.c_str(), AT_SYMLINK_FOLLOW) ==
            0) {
            place_ = Place::linked;
            return;
        }
        if (errno != EEXIST) throw write_error(target_, errno);
        take_name(names);  // another process created the target meanwhile
    }
    if (one_of_many && exchange()) {
        place_ = Place::exchanged;
        return;
    }
    if (std::rename(temporary_.c_str(), real_path_.c_str()) != 0) throw write_error(target_, errno);
    names.remove(temporary_);
    temporary_.clear();
    place_ = Place::replaced;
}

/// Undoes take_place() as far as it can be undone. Needs no memory.
void AtomicFile::give_back_place() noexcept {
    if (place_ == Place::linked) ::unlink(real_path_.c_str());
    if (place_ == Place::exchanged)
        ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, real_path_.c_str(), RENAME_EXCHANGE);
}

/// Removes the file of the temporary name, if there is one.
void AtomicFile::remove_temporary(TemporaryNames& names) noexcept {
    if (temporary_.empty()) return;
    ::unlink(temporary_.c_str());
    names.remove(temporary_);
    temporary_.clear();
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

/// Those of the files that have taken their places; without done() they give them back.
class AtomicFile::Placed {
  public:
    Placed(std::span<AtomicFile> files, TemporaryNames& names) : files_(files), names_(names) {}
    ~Placed() {
        while (count_ > 0) files_[--count_].give_back_place();
    }
    Placed(const Placed&) = delete;
    Placed& operator=(const Placed&) = delete;
    void place_all() {
        for (AtomicFile& file : files_) {
            file.take_place(names_, files_.size() > 1);
            ++count_;
        }
        for (AtomicFile& file : files_) file.remove_temporary(names_);  // the old files
        count_ = 0;
    }

  private:
    std::span<AtomicFile> files_;
    TemporaryNames& names_;
    std::size_t count_ = 0;
};

std::vector<CommittedFile> commit_together(std::span<AtomicFile> files) {
    for (AtomicFile& file : files) file.finish();
    std::vector<CommittedFile> committed;
    for (const AtomicFile& file : files) committed.push_back(file.committed());
    if (files.empty()) return committed;
    const Turn turn(folder_of(files.back().real_path_));
    TemporaryNames names;
    for (AtomicFile& file : files) file.name_beside_old(names);
    AtomicFile::Placed(files, names).place_all();
    return committed;
}

void make_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && std::filesystem::is_directory(folder)) return;
    throw Error(ExitCode::io, fmt::format("{}: cannot make this folder: {}", folder,
                                          error ? error.message() : "it is a file"));
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
