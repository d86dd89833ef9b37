#pragma once
// A whole file as bytes, with the operating system's reason when it cannot be had.
#include <cstdint>
#include <string>
#include <vector>

#include "app/byte_sink.h"

namespace burl {

/// Throws Error(io) naming the path and the reason (missing, a folder, no permission).
std::vector<std::uint8_t> read_file_bytes(const std::string& path);

/// The same piece by piece, for files that need not be in memory as a whole.
void read_file_pieces(const std::string& path, const ByteSink& sink);

}  // namespace burl
