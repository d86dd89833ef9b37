#pragma once
// The containers of glTF 2.0: the head of a .glb, names of files in a .gltf.
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "atlas/base/error.h"

namespace burl {

/// Most bytes of a .glb.
inline constexpr std::uint64_t most_glb_bytes = std::numeric_limits<std::uint32_t>::max();

/// Says that a .glb would have more than most_glb_bytes.
Error glb_too_long(const std::string& path);

/// The JSON's text with `indent` spaces a level, -1: on one line; invalid UTF-8 becomes U+FFFD.
std::string gltf_text(const nlohmann::ordered_json& json, int indent);

/// The container's bytes before the buffer: file header, JSON chunk and the buffer chunk's header.
/// The JSON is padded with spaces to `length` bytes, a multiple of 4.
std::string glb_head(const std::string& json, std::size_t length, std::uint64_t binary_size);

/// The uri, relative to a .gltf in the same folder, of the file at `path`: its name with everything
/// but RFC 3986's unreserved characters escaped.
std::string relative_uri(const std::string& path);

}  // namespace burl
