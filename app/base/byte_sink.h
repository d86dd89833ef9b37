#pragma once
// Files as a stream of bytes: a texture's file does not fit into memory beside a texture of 16384 x
// 16384 texels and its atlas, so encoders hand on what they have as it comes.
#include <cstdint>
#include <functional>
#include <span>

namespace burl {

/// Takes a file's content piece by piece, each valid during the call only. May throw.
using ByteSink = std::function<void(std::span<const std::uint8_t>)>;

/// Gives a file's content to the sink, the same at every call. Empty: no such file.
using ByteSource = std::function<void(const ByteSink&)>;

}  // namespace burl
