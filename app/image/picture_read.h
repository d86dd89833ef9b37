#pragma once
// Pictures of files from anywhere: PNG, JPEG and WebP, by their first bytes.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/image/image_io.h"
#include "atlas/base/enum_names.h"

namespace burl {

/// The format of an encoded picture.
enum class PictureType { unknown, png, jpeg, webp, ktx2 };
template <>
inline constexpr auto enum_names<PictureType> = enum_words("of unknown type", "PNG", "JPEG", "WebP",
                                                           "KTX2");

/// The format that the signature of the bytes says.
PictureType picture_type(std::span<const std::uint8_t> bytes);

/// Whether decode_picture() reads the format.
constexpr bool is_read(PictureType type) {
    return type == PictureType::png || type == PictureType::jpeg || type == PictureType::webp;
}

/// The names of the formats that are read, for messages.
inline constexpr auto pictures_read = "PNG, JPEG or WebP";

/// Reads bytes in memory as 8-bit colours, with alpha where the file has it; `origin` names them in
/// messages. A damaged or truncated picture is refused. Throws Error: unsupported for a format that
/// is not read and for JPEG of four components, invalid_file for what is damaged or has more than
/// 2^28 pixels.
PictureColors decode_picture(std::span<const std::uint8_t> bytes, const std::string& origin);

/// The bytes of a regular file, for decode_picture(). Throws Error: io, and invalid_file where they
/// do not begin as a format that is read does.
std::vector<std::uint8_t> read_picture_bytes(const std::string& path);

/// Reads a file. Throws Error as read_picture_bytes() and decode_picture() do.
PictureColors read_picture(const std::string& path);

/// The size in pixels that a file's head declares, which need not be true. Throws Error as
/// read_picture() does.
PngSize picture_size(const std::string& path);

}  // namespace burl
