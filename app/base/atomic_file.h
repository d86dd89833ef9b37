#pragma once
// Output that is either whole or absent. The bytes go into a nameless file of the target's folder
// (O_TMPFILE); once all files of a group are complete and safe on disk they get their names at
// once: a target that is new is linked, an old one replaced by way of a temporary name. A run that
// fails, is interrupted or killed leaves the old file or none. Only a run that is killed (SIGKILL,
// SIGQUIT, a crash, power) within the microseconds between two names may leave ".NAME.N.burl-tmp"
// behind; N is 0 but for runs that write NAME at a time. The next run that writes NAME removes that
// of 0, and any other once it needs such a name itself. Where the file system has no nameless files
// that name is used from the start.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/byte_sink.h"

namespace burl {

enum class Temporary {
    nameless,  ///< O_TMPFILE where the file system has it, else named
    named,     ///< a hidden name from the start
};

/// A file as it was committed. Another one in its place has another inode, even where size and time
/// are the same.
struct CommittedFile {
    std::string path;  ///< as the user named it
    std::uint64_t bytes = 0, inode = 0;
    std::int64_t seconds = 0, nanoseconds = 0;  ///< of its last change
    bool operator==(const CommittedFile&) const = default;
};

/// The state of the file at the path; nothing where there is none.
std::optional<CommittedFile> file_there(const std::string& path);

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

    /// Appends; large or small pieces alike. Throws Error(io) (disk full, ...).
    void write(std::span<const std::uint8_t> bytes);
    void write(std::string_view text);

    /// Puts bytes in the place of some written before, such as a header whose numbers were not
    /// known. Throws Error(io).
    void overwrite(std::uint64_t position, std::span<const std::uint8_t> bytes);

    /// Flushes everything to disk; nothing may be written after. Throws Error(io).
    void finish();

    /// Takes the target's place; finishes first if that was not done. Throws Error(io).
    CommittedFile commit();

    const std::string& target() const { return target_; }

  private:
    friend std::vector<CommittedFile> commit_together(std::span<AtomicFile> files);
    void flush();
    void write_through(std::span<const std::uint8_t> bytes);
    template <class WriteSome>
    void write_whole(std::span<const std::uint8_t> bytes, const WriteSome& write_some);
    void take_name();
    void name_beside_old();
    void take_place();
    CommittedFile committed() const;
    void discard() noexcept;

    std::string target_;     // as the user named it, for messages
    std::string real_path_;  // after symbolic links
    std::string temporary_;  // empty while nameless
    int descriptor_ = -1;
    bool replaces_ = false;  // the target existed before
    bool finished_ = false;
    std::vector<std::uint8_t> buffer_;
};

/// Appends to the file, which must outlive it; for encoders that give their bytes piece by piece.
ByteSink sink_of(AtomicFile& file);

/// Commits files that only make sense together (.obj, .mtl, .png): all are finished before the
/// first gets its name, in the order given, so put the one that names the others last. When one
/// fails, files that did not exist before are removed again. Throws Error(io).
std::vector<CommittedFile> commit_together(std::span<AtomicFile> files);

/// One file written whole or not at all. Throws Error(io).
CommittedFile write_file(const std::string& path, std::span<const std::uint8_t> bytes);
CommittedFile write_file(const std::string& path, std::string_view text);

/// Makes a folder to write into, with those above it, unless it is there. Throws Error(io).
void make_folder(const std::string& folder);

/// From here on SIGINT, SIGTERM and SIGHUP, where they are not ignored, wait while files get their
/// names and remove temporary ones before they end the program. To be called once, before other
/// threads are started: it blocks these signals for the calling thread and takes them in one of its
/// own.
void clean_up_on_signals();

}  // namespace burl
