#pragma once
// Cells of the quad atlas, one for each block: two triangles across the edge that becomes the
// block's diagonal, or one that found no partner, with the number of texels they ask for. Pairs are
// matched so that the sum of the texels asked for is small.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// A triangle pair or a single triangle. Lengths are in mesh units times unit_scale(mesh). The x
/// leg of a triangle runs from its right angle to the next corner, the y leg to the corner after
/// that.
struct QuadCell {
    std::int32_t lower = -1, upper = -1;              ///< triangles; upper -1: a single triangle
    std::uint8_t lower_corner = 0, upper_corner = 0;  ///< corners at the right angles, 0..2
    Vec3d centre{0.0};                                ///< mean of the three or four corners
    double demand = 0.0;                              ///< texels wanted, in a unit common to cells
    double aspect = 1.0;                              ///< best width / height of the block
    /// Distance of the pair from a parallelogram, on which its two affine maps agree: the distance
    /// between the middles of the two diagonals, divided by half the diagonal that the triangles
    /// share.
    double kink = 0.0;
    /// Coefficients of the squared error of bilinear lookup with legs of sx and sy texels, in a
    /// unit common to all cells: error[0] / sx^4 + error[1] / (sx^2 sy^2) + error[2] / sy^4.
    std::array<double, 3> error{};
};

/// Cells of all triangles of the mesh, ordered by lowest triangle. `opposite` is the result of
/// opposite_half_edges(). Triangles without area ask for nothing. No pair asks for more than
/// `most_cost` times the texels that its triangles would ask for as singles.
std::vector<QuadCell> make_quad_cells(const Mesh& mesh, std::span<const std::int32_t> opposite,
                                      AtlasWeight weight, double most_cost);

}  // namespace burl
