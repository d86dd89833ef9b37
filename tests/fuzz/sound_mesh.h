#pragma once
// What every mesh that was read must be, and every atlas that was made of one.
#include "atlas/build/mesh_atlas.h"
#include "atlas/mesh/mesh.h"

namespace burl::fuzz {

/// Ends the program where the mesh is not what build_mesh() promises.
void check_mesh(const Mesh& mesh);

/// Ends the program where the atlas of the mesh is not of its size, has a place, a point or a
/// measure that is not finite, a texel with two owners, or charts that overlap.
void check_atlas(const Mesh& mesh, const Connectivity& connectivity, const MeshAtlas& atlas);

}  // namespace burl::fuzz
