#pragma once
// One function for every mesh format. The readers are Burl's own: the packaged ones round doubles,
// reorder faces and drop bad lines in silence (docs/reference/meshes.md).
#include <stop_token>
#include <string>

#include "atlas/mesh/mesh.h"

namespace burl {

/// Reads .obj, .ply, .stl, .off, .gltf or .glb by extension (any case).
/// Throws Error: io when the file cannot be read, unsupported for another extension or an unknown
/// glTF extension that the file requires, invalid_file ("file:line: message") when its content is
/// wrong (also when it holds no face at all), runtime where `stop` is requested, which text looks
/// for every 4096 lines, and what follows between passes over the mesh.
Mesh read_mesh(const std::string& path, const ReadOptions& options = {},
               const std::stop_token& stop = {});

/// Throws Error as read_mesh() does for a file of another format, or one that is missing or may not
/// be read; reads nothing of it.
void check_mesh_file(const std::string& path);

}  // namespace burl
