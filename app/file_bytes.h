#pragma once
// A whole file as bytes, with the operating system's reason when it cannot be had.
#include <cstdint>
#include <string>
#include <vector>

namespace burl {

/// Throws Error(io) naming the path and the reason (missing, a folder, no permission).
std::vector<std::uint8_t> read_file_bytes(const std::string& path);

}  // namespace burl
