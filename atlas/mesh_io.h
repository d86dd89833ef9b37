#pragma once
// One door for every mesh format. The readers are ours: the packaged ones round doubles, reorder
// faces and drop bad lines in silence (docs/meshes.md).
#include <string>

#include "atlas/mesh.h"

namespace burl {

struct ReadOptions {
    /// Points closer than this times the box's longest side are welded; 0 welds bitwise-equal
    /// points (after -0 -> 0).
    double weld = 0.0;
    /// Give each glTF instance triangles of its own, in scene space, instead of baking the first
    /// one for all.
    bool unshare_instances = false;
};

/// Reads .obj, .ply, .stl, .off, .gltf or .glb by extension (any case).
/// Throws Error: io when the file cannot be read, unsupported for another extension or a required
/// glTF extension we lack, invalid_file ("file:line: message") when its content is wrong (also when
/// it holds no face at all).
Mesh read_mesh(const std::string& path, const ReadOptions& options = {});

}  // namespace burl
