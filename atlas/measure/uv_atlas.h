#pragma once
// A mesh's own texture coordinates as an atlas, so that any program's unwrapped UVs are measured by
// the same code as Burl's layouts.
#include <cstdint>
#include <span>

#include "atlas/solid/solid_atlas.h"

namespace burl {

/// The atlas of a mesh with UVs. Corners are mesh.corners.uvs times `size` (v = 0 is the edge of
/// row 0), charts the components joined by equal UVs; there are no blocks.
Atlas atlas_from_uvs(const Mesh& mesh, const Connectivity& connectivity, std::uint32_t size);

/// The solid points of the texels; `positions` are the mesh's points in the space wanted. Every
/// texel whose centre lies in or on a triangle belongs to the lowest such triangle; other texels
/// belong to none. Triangles without area in the texture own nothing.
SolidAtlas rasterize_uvs(const Mesh& mesh, const Atlas& atlas, std::span<const Vec3d> positions);

}  // namespace burl
