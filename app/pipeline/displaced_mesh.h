#pragma once
// Displacement: the surface itself moved by a recipe's height (Cook, "Shade Trees", 1984), where a
// normal map only shades as if it were.
#include "app/recipe/recipe.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The mesh with every point moved along its normal by bump.height times the value of bump.input
/// there, in float64. `rest` is the mesh in whose box the recipe's solid lies, which has the points
/// of `mesh` or fewer. A point's normal is the mean of its corners' normals, which are the mesh's
/// own where it has some, weighted by the corners' angles, so that nothing tears at creases. Masks
/// are those of `mesh` at its points, on one of their triangles. The result has no normals;
/// bump.input must be there.
Mesh displaced_mesh(const Mesh& mesh, const Recipe& recipe, const Mesh& rest);

}  // namespace burl
