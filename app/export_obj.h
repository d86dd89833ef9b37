#pragma once
// Wavefront OBJ output. Text has room for every digit, so positions are the input's own doubles in
// the input's own coordinates, not centred floats.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "atlas/atlas.h"
#include "atlas/mesh.h"

namespace burl {

/// PATH, NAME.mtl, NAME.png (the bytes of `png`) and MIP level l in NAME.l.png beside it; all or
/// none. Faces in the mesh's
/// order, `v` in the shortest form that reads back to the same double, `vt` with v upwards. Further
/// placements of a part follow as copies of their own, since OBJ has no instances. `normals` are
/// per corner. Throws Error(io).
void write_obj(const std::string& path, const Mesh& mesh, const Atlas& atlas,
               std::span<const Vec3f> normals, std::span<const std::uint8_t> png,
               std::span<const std::vector<std::uint8_t>> levels = {});

}  // namespace burl
