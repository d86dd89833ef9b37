#pragma once
// A whole file in memory. Readers parse from one contiguous buffer, so a file that is cut or
// changed while it is read can at worst give an error, never a fault (as a memory map could).
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace burl {

/// The bytes of a file and the path that messages name it by.
struct FileBuffer {
    std::string path;  ///< path as given, for messages
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;

    std::string_view text() const { return {bytes.get(), size}; }
};

/// Reads a regular file. Throws Error(io), with the system's reason, when it is missing, a folder,
/// a device, or may not be read.
FileBuffer read_file(const std::string& path);

/// A buffer that holds a copy of `content`; `path` is only its name in messages.
FileBuffer buffer_from(std::string_view content, std::string path);

}  // namespace burl
