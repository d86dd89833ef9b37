#pragma once
// One safe way to load a glTF or GLB: the file is checked as a whole before tinygltf sees it, since
// tinygltf follows offsets and indices into memory unchecked.
#include <string>

#include "atlas/file/file_buffer.h"

namespace tinygltf {
class Model;
}

namespace burl {

/// Loads .gltf or .glb (told apart by content). In the result every bufferView lies inside its
/// buffer, every accessor inside its view, every index names something that exists, vertex indices
/// are in range, and nodes form trees. Images stay encoded: `image.image` holds the PNG or JPEG
/// bytes and `as_is` is set; it is empty where an image's file is missing or outside the glTF's
/// folder. Files that it names are read from the glTF's own folder and
/// below, unless `file.named` says anywhere. Throws Error: io
/// when a file cannot be read, invalid_file when the content is wrong, unsupported for a required
/// extension that would change the geometry (Draco, meshopt ...).
tinygltf::Model load_gltf(const std::string& path);

/// Loads a .gltf or .glb that is in memory, with the checks and errors of load_gltf(path); files
/// that it names are looked for beside `file.path`.
tinygltf::Model load_gltf(const FileBuffer& file);

}  // namespace burl
