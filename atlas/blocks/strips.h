#pragma once
// The order in which pairs and singles go into the atlas. Pairs linked through opposite edges form
// triangle strips, which lie side by side without overscan (Carr & Hart 2001, section 4.1); strips
// are sorted by non-increasing weight (section 4.2).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// What one block of the atlas holds, before it has a place.
struct Cell {
    std::int32_t lower = -1, upper = -1;              ///< triangles; upper -1: one triangle alone
    std::uint8_t lower_corner = 0, upper_corner = 0;  ///< corners with the right angle
    bool shares_hypotenuse = false;                   ///< the two are a matched pair
    bool joins_previous = false;  ///< its left edge is the right edge of the cell before it
    double weight = 0.0;          ///< leg_x * leg_y wanted: the sum of both triangles' weights

    bool holds_strangers() const { return upper >= 0 && !shares_hypotenuse; }
    int triangles() const { return upper >= 0 ? 2 : 1; }
};

/// Cells of all triangles in the order they are to be laid, rows first. `partner_edges` is
/// pair_triangles' result. A strip is cut where the weights in it would differ by more than a
/// factor of `most_ratio`.
std::vector<Cell> order_cells(const Mesh& mesh, std::span<const std::int32_t> opposite,
                              std::span<const std::int8_t> partner_edges,
                              std::span<const float> weights, double most_ratio);

/// Splits every cell that holds two unrelated triangles into two cells of one.
std::vector<Cell> part_strangers(std::span<const Cell> cells, std::span<const float> weights);

}  // namespace burl
