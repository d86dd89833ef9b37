#pragma once
// A whole file as bytes, with the operating system's reason when it cannot be had.
#include <cstdint>
#include <string>
#include <vector>

#include "app/base/byte_sink.h"

namespace burl {

/// A regular file, or what comes out of a pipe, at most 256 MiB. Throws Error(io) naming the path
/// and the reason (missing, a folder, a device, no permission).
std::vector<std::uint8_t> read_file_bytes(const std::string& path);

/// For files that a user's file names: a regular file of at most `most` bytes, since a pipe may
/// keep its reader waiting and a device may never end. Throws Error(io).
std::vector<std::uint8_t> read_regular_file(const std::string& path, std::uint64_t most);

/// Its first bytes, at most as many as that.
std::vector<std::uint8_t> read_file_head(const std::string& path, std::size_t bytes);

/// A regular file piece by piece, for what need not be in memory as a whole. Throws Error(io).
void read_file_pieces(const std::string& path, const ByteSink& sink);

}  // namespace burl
