#pragma once
// Noise far from the origin: float64 splits a lattice coordinate into a cell and the fraction
// within it, and the fraction keeps fewer bits the farther out it lies.
#include "app/recipe/recipe.h"

namespace burl {

/// The largest lattice coordinate supported, in cells: beyond it the fraction has six bits or
/// fewer.
inline constexpr double farthest_cell = 0x1p46;

/// Throws Error(unsupported), in one sentence that names the noise term or the graph's node, where
/// the recipe's texture or bumps have lattice coordinates beyond farthest_cell, or not finite ones,
/// anywhere in a box of texture coordinates.
void check_lattice(const Recipe& recipe, const Box3& texture_box);

/// Checks the recipe in the box of texture coordinates that it gives the mesh's bounding box.
void check_lattice(const Recipe& recipe, const Mesh& mesh);

}  // namespace burl
