#pragma once
// Wavefront OBJ output. Text has room for every digit, so positions are the input's own doubles in
// the input's own coordinates, not centred floats.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/byte_sink.h"
#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

struct ObjContent {
    const Mesh& mesh;
    const Atlas& atlas;
    std::span<const Vec3f> normals;      ///< per corner
    std::string name;                    ///< of the material; characters no .mtl takes become _
    ByteSource png;                      ///< the texture's file content
    std::span<const ByteSource> levels;  ///< of MIP levels 1, 2, ...
    ByteSource normal_png{};             ///< may be empty
    bool tangent_space = true;           ///< the normal map: named in the material
};

/// PATH, NAME.mtl, NAME.png, MIP level l in NAME.l.png and the normal map in NAME_normal.png beside
/// it; all are complete and have yet to be committed together. Faces in the mesh's order, `v` in
/// the shortest form that reads back to the same double, `vt` with v upwards. Further placements of
/// a part follow as copies of their own, since OBJ has no instances. Throws Error(io).
std::vector<AtomicFile> write_obj(const std::string& path, const ObjContent& content);

}  // namespace burl
