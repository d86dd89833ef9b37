#pragma once
// Atlases for tests of levels.
#include "atlas/build/mesh_atlas.h"

namespace burl::made {

inline MeshAtlas atlas_of(const Mesh& mesh, AtlasKind kind, std::uint32_t size) {
    return build_atlas(mesh, build_connectivity(mesh), {.kind = kind, .size = size});
}

}  // namespace burl::made
