#pragma once
// A mesh of some of another's faces: the part of a file that is carved.
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// The triangles of faces whose entry of `chosen`, by Mesh::source_faces, is not 0, with the points
/// that they use, in their order; parts without triangles are left out. Notes stay those of the
/// whole mesh but for the number of unchosen triangles, and at least one triangle must be chosen.
Mesh with_faces(const Mesh& mesh, const std::vector<char>& chosen);

}  // namespace burl
