#pragma once
// Bytes as scripts: a web page that was opened from a disk may load scripts and pictures, and no
// other files. A script calls burlData(FILE, TEXT) (viewer/data.js) with its bytes in base64.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/file_bytes.h"
#include "atlas/base/image.h"

namespace burl {

/// The bytes in base64 (RFC 4648, with padding).
std::string base64(std::span<const std::uint8_t> bytes);

/// Passes the script of a page's file to the sink, in pieces. `file` is its path below the page,
/// of letters, digits, '-', '.' and '/'.
void write_data_script(std::string_view file, std::span<const std::uint8_t> bytes,
                       const ByteSink& sink);

/// Light as pixels of four bytes: red, green, blue and their exponent (Ward, "Real Pixels", 1991),
/// whose value is (byte + 1/2) 2^(exponent - 136), within 2^-8 of the largest; four zeros for no
/// light.
std::vector<std::uint8_t> rgbe_pixels(std::span<const RgbF> light);

}  // namespace burl
