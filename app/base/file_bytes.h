#pragma once
// Contents of files as bytes, whole or in pieces: the file of a texture of 16384 x 16384 texels
// does not fit into memory beside the texture and its atlas. Errors give the operating system's
// reason.
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace burl {

/// Receives a file's content in pieces, each valid during the call only. May throw.
using ByteSink = std::function<void(std::span<const std::uint8_t>)>;

/// The content of a regular file, or of a pipe up to 256 MiB. Throws Error(io) naming the path and
/// the reason (missing, a folder, a device, no permission).
std::vector<std::uint8_t> read_file_bytes(const std::string& path);

/// The content of a regular file of at most `most` bytes, for paths that come from a user's file: a
/// pipe may keep its reader waiting and a device may never end. Throws Error(io).
std::vector<std::uint8_t> read_regular_file(const std::string& path, std::uint64_t most);

/// The first bytes of a regular file, at most `bytes` of them. Throws Error(io).
std::vector<std::uint8_t> read_file_head(const std::string& path, std::size_t bytes);

/// Reads a regular file in pieces of at most 256 KiB, so that it is never in memory as a whole.
/// Throws Error(io).
void read_file_pieces(const std::string& path, const ByteSink& sink);

}  // namespace burl
