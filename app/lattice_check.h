#pragma once
// Noise far from the origin: float64 splits a lattice coordinate into cell and place, and the place
// keeps the fewer bits the farther out it lies.
#include "app/recipe.h"

namespace burl {

/// From here on a place has six bits or fewer: 2^46 cells.
inline constexpr double farthest_cell = 0x1p46;

/// Throws Error(unsupported), in one sentence that names the noise term, if an octave of the
/// recipe's texture has lattice coordinates beyond farthest_cell, or not finite, anywhere in a box
/// of texture coordinates. Octaves of amplitude 0 and graphs are not looked at.
void check_lattice(const Recipe& recipe, const Box3& texture_box);

/// In the box that the recipe's solid makes of the mesh's.
void check_lattice(const Recipe& recipe, const Mesh& mesh);

}  // namespace burl
