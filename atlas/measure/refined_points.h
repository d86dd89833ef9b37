#pragma once
// Points of a mesh on the triangles of its refinement, so that atlases that split triangles are
// judged at the same points as those that do not.
#include "atlas/build/mesh_atlas.h"
#include "atlas/measure/surface_points.h"

namespace burl {

/// The points, of `input`, as points of atlas.mesh(input) at the same places of the surface.
std::vector<SurfacePoint> refined_points(const Mesh& input, const MeshAtlas& atlas,
                                         std::vector<SurfacePoint> points);

}  // namespace burl
