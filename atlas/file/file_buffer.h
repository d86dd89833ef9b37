#pragma once
// A whole file in memory. Readers parse from one contiguous buffer, so a file that is cut or
// changed while it is read can at worst give an error, never a fault (as a memory map could).
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "atlas/base/named_files.h"

namespace burl {

/// The bytes of a file and the path that messages name it by.
struct FileBuffer {
    std::string path;  ///< path as given, for messages
    std::unique_ptr<char[]> bytes;
    std::size_t size = 0;
    std::stop_token stop{};                ///< a request that parsers of text stop (TextScanner)
    NamedFiles named = NamedFiles::below;  ///< where files that it names may lie

    std::string_view text() const { return {bytes.get(), size}; }
};

/// Reads a regular file; files that it names may lie where `named` says. Throws Error(io), with the
/// system's reason, when it is missing, a folder, a device, or may not be read.
FileBuffer read_file(const std::string& path, NamedFiles named = NamedFiles::below);

/// Throws Error as read_file() does for a file that is missing, no regular file, or may not be
/// read; reads nothing of it.
void check_file(const std::string& path);

/// A buffer that holds a copy of `content`; `path` is only its name in messages.
FileBuffer buffer_from(std::string_view content, std::string path);

/// The number stored at `bytes`, at any alignment; `swapped` says that its byte order is not this
/// machine's.
template <typename Value>
Value load(const char* bytes, bool swapped = false) {
    std::array<char, sizeof(Value)> raw;
    std::memcpy(raw.data(), bytes, sizeof(Value));
    if (swapped) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Value>(raw);
}

/// Whether this machine stores the highest byte of a number first.
inline constexpr bool big_endian_machine = std::endian::native == std::endian::big;

}  // namespace burl
