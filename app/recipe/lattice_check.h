#pragma once
// Noise far from the origin: float64 splits a lattice coordinate into a cell and the fraction
// within it, and the fraction keeps fewer bits the farther out it lies.
#include "app/recipe/recipe.h"

namespace burl {

/// The largest lattice coordinate supported, in cells: beyond it the fraction has six bits or
/// fewer.
inline constexpr double farthest_cell = 0x1p46;

/// The largest lattice coordinate of a texture's noise, in cells from the origin, with its noise
/// term and octave; the search ends at the first beyond farthest_cell.
struct LatticeReach {
    double reach = 0.0;  ///< infinite where a coordinate is not finite
    std::size_t term = 0;
    std::uint32_t octave = 0;
};

/// The reach of the texture's noise where absolute texture coordinates are at most `sizes`. Octaves
/// of amplitude 0 do not count.
LatticeReach farthest_lattice(const Texture& texture, const Vec3d& sizes);

/// The end of a sentence about a noise that reaches so many cells from the origin: the problem and
/// its remedies.
std::string too_far(double cells);

/// Throws Error(unsupported), in one sentence that names the noise term or the graph's node, where
/// the recipe's texture or bumps have lattice coordinates beyond farthest_cell, or not finite ones,
/// anywhere in a box of texture coordinates.
void check_lattice(const Recipe& recipe, const Box3& texture_box);

/// Checks the recipe in the box of texture coordinates that it gives the mesh's bounding box.
void check_lattice(const Recipe& recipe, const Mesh& mesh);

}  // namespace burl
