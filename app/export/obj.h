#pragma once
// Wavefront OBJ output. Text holds every digit, so positions are the input's doubles in its own
// coordinates, rather than centred floats.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/file_bytes.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

struct ObjContent {
    const Mesh& mesh;
    const Atlas& atlas;
    std::span<const Vec3f> normals;  ///< one per triangle corner
    std::string name;  ///< the material's name; characters that .mtl does not allow become _
    ByteSource png;    ///< the texture's file content
    std::span<const ByteSource> levels;  ///< the PNG contents of MIP levels 1, 2, ...
    ByteSource normal_png{};             ///< the normal map's file content; may be empty
    bool tangent_space = true;           ///< whether the material names the normal map
};

/// Writes PATH and beside it NAME.mtl, NAME.png, MIP levels NAME.l.png and the normal map
/// NAME_normal.png, which the caller commits together. Faces are in the mesh's order, `v` in the
/// shortest form that reads back to the same double, `vt` with v upwards. Further placements of a
/// part are copies, since OBJ has no instances. Throws Error(io).
std::vector<AtomicFile> write_obj(const std::string& path, const ObjContent& content);

}  // namespace burl
