#pragma once
// Vertex arrays of placed parts for glTF nodes. A node translates, rotates and scales; any other
// placement must be applied to the vertices.
#include "app/export/vertices.h"
#include "app/surface/node_transform.h"

namespace burl {

/// The placement for the arrays, whose positions are relative to their centre and scale.
Mat4d centred(const Mat4d& placement, const PartVertices& vertices);

/// The part's arrays transformed by a placement that no node can express (shear, flattening):
/// positions relative to the placed centre; triangles reversed where the placement mirrors.
PartVertices placed(const PartVertices& vertices, const Mat4d& placement);

/// The translation and scale of a node for arrays that placed() has made.
NodeTransform node_of_placed(const PartVertices& vertices);

}  // namespace burl
