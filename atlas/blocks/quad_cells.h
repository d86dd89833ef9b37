#pragma once
// What shares a block of the quad atlas: two triangles across the edge that becomes the block's
// diagonal, or one that found no partner, with the texels they ask for. Pairs are matched so that
// the texels asked for in all are few.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/solid/atlas.h"

namespace burl {

/// Lengths are in mesh units times unit_scale(mesh). The x leg of a triangle runs from its right
/// angle to the next corner, the y leg to the one after.
struct QuadCell {
    std::int32_t lower = -1, upper = -1;              ///< upper -1: a single
    std::uint8_t lower_corner = 0, upper_corner = 0;  ///< at the right angle
    Vec3d centre{0.0};                                ///< mean of the three or four corners
    double demand = 0.0;                              ///< texels wanted, in any common unit
    double aspect = 1.0;                              ///< width / height that serves it best
    /// How far the pair is from a parallelogram, whose two maps agree: the distance of the
    /// diagonals' middles over half the diagonal on which they meet.
    double kink = 0.0;
    /// Squared error of bilinear lookup with legs of sx and sy texels, in any common unit:
    /// error[0] / sx^4 + error[1] / (sx^2 sy^2) + error[2] / sy^4.
    std::array<double, 3> error{};
};

/// All triangles of the mesh in cells, by lowest face. `opposite` as of opposite_half_edges.
/// Triangles without area ask for nothing. No pair asks for more than `most_cost` times what its
/// triangles would as singles.
std::vector<QuadCell> make_quad_cells(const Mesh& mesh, std::span<const std::int32_t> opposite,
                                      AtlasWeight weight, double most_cost);

}  // namespace burl
