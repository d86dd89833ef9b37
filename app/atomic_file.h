#pragma once
// Output that is either whole or absent. The bytes go into a nameless file of the target's folder
// (O_TMPFILE), get a temporary name once they are complete and safe on disk, and are renamed over
// the target: a run that fails, is interrupted or killed leaves the old file or none. Where the
// file system has no nameless files a hidden temporary name is used from the start; then a killed
// run (not a failed one) may leave ".NAME.PID-N.burl-tmp" behind.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/byte_sink.h"

namespace burl {

enum class Temporary {
    nameless,  ///< O_TMPFILE where the file system has it, else named
    named,     ///< a hidden name from the start
};

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

    /// Flushes everything to disk and gives it the temporary name; nothing may be written after.
    /// Throws Error(io).
    void finish();

    /// Renames over the target; finishes first if that was not done. Throws Error(io).
    void commit();

    const std::string& target() const { return target_; }

  private:
    friend void commit_together(std::span<AtomicFile> files);
    void flush();
    void write_through(std::span<const std::uint8_t> bytes);
    template <class WriteSome>
    void write_whole(std::span<const std::uint8_t> bytes, const WriteSome& write_some);
    void take_name();
    void discard() noexcept;

    std::string target_;     // as the user named it, for messages
    std::string real_path_;  // after symbolic links
    std::string temporary_;  // empty while nameless
    int descriptor_ = -1;
    bool replaces_ = false;  // the target existed before
    std::vector<std::uint8_t> buffer_;
};

/// Appends to the file, which must outlive it; for encoders that give their bytes piece by piece.
ByteSink sink_of(AtomicFile& file);

/// Commits files that only make sense together (.obj, .mtl, .png): all are finished before the
/// first is renamed, in the order given, so put the one that names the others last. When a rename
/// fails, files that did not exist before are removed again. Throws Error(io).
void commit_together(std::span<AtomicFile> files);

/// One file written whole or not at all. Throws Error(io).
void write_file(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file(const std::string& path, std::string_view text);

}  // namespace burl
