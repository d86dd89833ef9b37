#pragma once
// The outer shell of a glTF: its JSON text, the GLB's binary chunk, and the files it names.
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "atlas/file/file_buffer.h"

namespace burl {

/// The JSON text and the binary chunk of a glTF file.
struct GltfParts {
    std::string_view json;
    std::uint64_t binary_bytes = 0;  ///< length of the GLB's binary chunk; 0 without one
    bool is_glb = false;
};

/// Splits a .glb into its chunks, or takes a .gltf as JSON. Throws Error(invalid_file) when a GLB's
/// lengths do not fit the file.
GltfParts split_gltf(const FileBuffer& file);

/// Whether the uri starts with "data:".
bool is_data_uri(std::string_view uri);

/// Number of bytes that a base64 data uri decodes to; -1 for one that tinygltf cannot decode.
std::int64_t data_uri_bytes(std::string_view uri);

/// The uri with %XX decoded, if it names a file in the glTF's folder or below: no scheme, no
/// absolute path, no "..", no backslash; where files may lie anywhere, no scheme and no backslash.
/// Empty otherwise. Symbolic links are not looked at (lies_below).
std::string confined_file_name(std::string_view uri, NamedFiles named = NamedFiles::below);
/// The end of a sentence about a uri that has no confined_file_name().
inline constexpr auto confined_rule =
    "may lead out of the file's folder, as absolute ones do, and those with '..', ':' or a "
    "backslash; put what it names beside the file, under a plain name";

}  // namespace burl
