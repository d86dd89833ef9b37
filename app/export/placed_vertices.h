#pragma once
// A part's vertex arrays in the places where the mesh has them, as a glTF node can say it: a node
// moves, turns and scales, and whatever else a placement does must be done to the vertices.
#include "app/export/vertices.h"
#include "app/surface/node_transform.h"

namespace burl {

/// The placement of arrays that are relative to their centre and scale.
Mat4d centred(const Mat4d& placement, const PartVertices& vertices);

/// The part's arrays in a placement no node can express (shear, flattening): positions moved there,
/// centred again; triangles turned over where it mirrors.
PartVertices placed(const PartVertices& vertices, const Mat4d& placement);

/// The node that puts arrays of placed() where they belong.
NodeTransform node_of_placed(const PartVertices& vertices);

}  // namespace burl
