#pragma once
// The order in which pairs and singles go into the atlas. Pairs linked through opposite edges form
// triangle strips, which lie side by side without overscan (Carr & Hart 2001, section 4.1); strips
// are sorted by non-increasing weight (section 4.2).
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// The content of one block of a strip atlas, before the block has a place.
struct Cell {
    std::int32_t lower = -1, upper = -1;              ///< triangles; upper -1: a single triangle
    std::uint8_t lower_corner = 0, upper_corner = 0;  ///< corners with the right angles, 0..2
    bool shares_hypotenuse = false;                   ///< whether the triangles are a matched pair
    bool joins_previous = false;  ///< left edge is the right edge of the cell before it
    double weight = 0.0;          ///< leg_x * leg_y wanted: the sum of both triangles' weights

    /// Whether the block holds two triangles that are not a matched pair.
    bool holds_strangers() const { return upper >= 0 && !shares_hypotenuse; }
    int triangles() const { return upper >= 0 ? 2 : 1; }
};

/// Cells of all triangles in layout order, row after row. `partner_edges` is the result of
/// pair_triangles(). A strip is cut where the weights in it would differ by more than a factor of
/// `most_ratio`.
std::vector<Cell> order_cells(const Mesh& mesh, std::span<const std::int32_t> opposite,
                              std::span<const std::int8_t> partner_edges,
                              std::span<const float> weights, double most_ratio);

/// The cells with every cell of two unrelated triangles split into two cells of one triangle each.
std::vector<Cell> part_strangers(std::span<const Cell> cells, std::span<const float> weights);

}  // namespace burl
