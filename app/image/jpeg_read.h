#pragma once
// JPEG files, read through libjpeg-turbo, and files that are PNG or JPEG, by their first bytes.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/image/image_io.h"
#include "atlas/base/image.h"

namespace burl {

/// Whether bytes begin as a JPEG file does.
bool is_jpeg(std::span<const std::uint8_t> bytes);

/// The size in pixels that a JPEG's headers declare. Throws Error(invalid_file) for a damaged one;
/// `origin` names it.
PngSize jpeg_size(std::span<const std::uint8_t> bytes, const std::string& origin);

/// The pixels of a JPEG as RGB; grey is expanded. Throws Error(invalid_file) for a file that is
/// damaged, ends too early, has four channels, or has more than 2^28 pixels.
Image<Rgb8> decode_jpeg(std::span<const std::uint8_t> bytes, const std::string& origin);

/// The size in pixels that the headers of a PNG or JPEG file declare. Throws Error as png_size
/// (image_io.h) and jpeg_size do.
PngSize picture_size(const std::string& path);

/// The bytes of a PNG or JPEG file, for decode_picture. Throws Error as read_png_bytes does.
std::vector<std::uint8_t> read_picture_bytes(const std::string& path);

/// The colours of a PNG or JPEG, with the alpha that a PNG has.
PngColors decode_picture(std::span<const std::uint8_t> bytes, const std::string& origin);

}  // namespace burl
