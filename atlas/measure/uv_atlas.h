#pragma once
// A mesh's own texture coordinates seen as an atlas, so that what any program unwrapped is measured
// by the same code as our layouts.
#include <cstdint>
#include <span>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// Corners are mesh.corners.uvs times `size` (v = 0 is the edge of row 0), charts the components
/// joined by equal UVs; there are no blocks. The mesh has UVs.
Atlas atlas_from_uvs(const Mesh& mesh, const Connectivity& connectivity, std::uint32_t size);

/// Every texel whose centre lies in or on a triangle belongs to the lowest such triangle; others to
/// none. Triangles without area in the texture own nothing.
SolidAtlas rasterize_uvs(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions);

}  // namespace burl
