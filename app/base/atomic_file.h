#pragma once
// Output files that are either whole or absent. The bytes go into a nameless file of the target's
// folder (O_TMPFILE). Once all files of a group are complete and synced to disk, they get their
// names together: a new target is linked, an existing one is replaced by renaming a temporary name
// over it. A run that fails, is interrupted or killed leaves the old file or none. Of several files
// the old ones are kept until all have their names, so that they come back where one name cannot be
// given (on file systems that can exchange files). Only a run that is killed (SIGKILL, SIGQUIT, a
// crash, power) within the microseconds between two names may leave ".NAME.N.burl-tmp" behind, N
// being 0, or more where several runs write NAME at the same time on a file system without nameless
// files, where the temporary name is used from the start. The next run that writes NAME removes
// them.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/file_bytes.h"

namespace burl {

enum class Temporary {
    nameless,  ///< O_TMPFILE where the file system has it, else a named file
    named,     ///< a hidden name from the start
};

/// The identity of a file when it was committed. A file that replaced it has another inode, even
/// where size and time of change are equal.
struct CommittedFile {
    std::string path;  ///< the path as the user gave it
    std::uint64_t bytes = 0, inode = 0;
    std::int64_t seconds = 0, nanoseconds = 0;  ///< the time of the file's last change
    bool operator==(const CommittedFile&) const = default;
};

/// The state of the file at the path; no value where there is none.
std::optional<CommittedFile> file_there(const std::string& path);

class TemporaryNames;

class AtomicFile {
  public:
    /// Opens the temporary file. A symbolic link is followed to the file it names; an existing
    /// file's permissions are kept, a new one gets the umask's. Throws Error(io) naming `target`
    /// when the folder is missing or not writable or the target is not a regular file.
    explicit AtomicFile(const std::string& target, Temporary kind = Temporary::nameless);
    /// Removes the temporary file unless committed.
    ~AtomicFile();
    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;

    /// Appends bytes through a buffer of 256 KiB. Throws Error(io) (disk full, ...).
    void write(std::span<const std::uint8_t> bytes);
    void write(std::string_view text);

    /// Overwrites bytes written earlier, from byte `position` of the file on: a header whose
    /// numbers were not known before, say. Throws Error(io).
    void overwrite(std::uint64_t position, std::span<const std::uint8_t> bytes);

    /// Flushes everything to disk; no write may follow. Throws Error(io).
    void finish();

    /// Gives the file the target's name; calls finish() first where that was not done. Throws
    /// Error(io).
    CommittedFile commit();

    const std::string& target() const { return target_; }

  private:
    friend std::vector<CommittedFile> commit_together(std::span<AtomicFile> files);
    void flush();
    void write_through(std::span<const std::uint8_t> bytes);
    template <class WriteSome>
    void write_whole(std::span<const std::uint8_t> bytes, const WriteSome& write_some);
    enum class Place { none, linked, exchanged, replaced };
    class Placed;
    void take_name(TemporaryNames& names);
    void name_beside_old(TemporaryNames& names);
    bool exchange();
    void take_place(TemporaryNames& names, bool one_of_many);
    void give_back_place() noexcept;
    void remove_temporary(TemporaryNames& names) noexcept;
    CommittedFile committed() const;
    void discard() noexcept;

    std::string target_;     // the path as the user gave it, for messages
    std::string real_path_;  // the target with symbolic links followed
    std::string temporary_;  // the temporary file's path; empty while it is nameless
    std::string handle_;     // the path of the nameless file in /proc, from the commit on
    int descriptor_ = -1;
    int old_ = -1;  // the target that was exchanged for this file
    Place place_ = Place::none;
    bool finished_ = false;
    std::vector<std::uint8_t> buffer_;
};

/// A sink that appends to the file, which must outlive it; for encoders that hand on their bytes in
/// pieces.
ByteSink sink_of(AtomicFile& file);

/// Commits files that only make sense together (.obj, .mtl, .png): all are finished before the
/// first gets its name, in the order given, so put the one that names the others last. When one
/// fails, new files are removed again and old ones come back. Groups of several runs with one last
/// folder do not mix. Throws Error(io).
std::vector<CommittedFile> commit_together(std::span<AtomicFile> files);

/// Writes one file, whole or not at all. Throws Error(io).
CommittedFile write_file(const std::string& path, std::span<const std::uint8_t> bytes);
CommittedFile write_file(const std::string& path, std::string_view text);

/// Creates the folder and its parents where they are missing. Throws Error(io).
void make_folder(const std::string& folder);

/// Makes SIGINT, SIGTERM and SIGHUP, unless they are ignored, wait while files get their names, and
/// remove temporary files before they end the program. Must be called once, before other threads
/// start: it blocks these signals in the calling thread and handles them in a thread of its own.
void clean_up_on_signals();

}  // namespace burl
