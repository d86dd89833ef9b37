#pragma once
// Files as streams of bytes: the file of a texture of 16384 x 16384 texels does not fit into memory
// beside the texture and its atlas, so encoders hand on bytes as they produce them.
#include <cstdint>
#include <functional>
#include <span>

namespace burl {

/// Receives a file's content in pieces, each valid during the call only. May throw.
using ByteSink = std::function<void(std::span<const std::uint8_t>)>;

/// Writes a file's whole content to the sink, the same bytes at every call. An empty function means
/// that there is no such file.
using ByteSource = std::function<void(const ByteSink&)>;

}  // namespace burl
