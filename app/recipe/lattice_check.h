#pragma once
// Noise far from the origin: float64 splits a lattice coordinate into cell and place, and the place
// keeps the fewer bits the farther out it lies.
#include "app/recipe/recipe.h"

namespace burl {

/// From here on a place has six bits or fewer: 2^46 cells.
inline constexpr double farthest_cell = 0x1p46;

/// How far a texture's noise reaches, in lattice cells from the origin: the farthest octave, or the
/// first beyond farthest_cell.
struct LatticeReach {
    double reach = 0.0;  ///< infinite where coordinates are not finite
    std::size_t term = 0;
    std::uint32_t octave = 0;
};

/// Where texture coordinates have at most these sizes. Octaves of amplitude 0 do not count.
LatticeReach farthest_lattice(const Texture& texture, const Vec3d& sizes);

/// What is wrong with a noise that reaches so far, as the end of a sentence.
std::string too_far(double cells);

/// Throws Error(unsupported), in one sentence that names the noise term or the graph's node, if the
/// recipe's texture or bumps have lattice coordinates beyond farthest_cell, or not finite, anywhere
/// in a box of texture coordinates.
void check_lattice(const Recipe& recipe, const Box3& texture_box);

/// In the box that the recipe's solid makes of the mesh's.
void check_lattice(const Recipe& recipe, const Mesh& mesh);

}  // namespace burl
