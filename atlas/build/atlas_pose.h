#pragma once
// A pose of the mesh that an atlas places, some of whose triangles the patch atlas has cut.
#include "atlas/build/mesh_atlas.h"
#include "atlas/read/pose.h"

namespace burl {

/// The pose of the mesh whose triangles the atlas places, made of the pose of the mesh that the
/// atlas was built for: the middles that a patch atlas puts on edges are the middles of the posed
/// edges. Throws Error as check_pose() does.
MeshPose atlas_pose(const MeshPose& pose, const Mesh& input, const MeshAtlas& atlas);

}  // namespace burl
