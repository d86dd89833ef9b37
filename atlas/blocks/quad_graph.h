#pragma once
// Clusters of the quad atlas by graph bisection, as in the paper: the graph of neighbouring pairs
// is bisected by a multilevel partitioner (Karypis & Kumar; Carr & Hart 2001, section 4.3), so that
// clusters have short borders and are mostly, though not always, connected on the surface.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/blocks/quad_order.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// The graph of cells and their neighbours in compressed sparse rows; the weight of an edge is the
/// length of the cells' common border, 64 for the mesh's mean edge.
class QuadGraph {
  public:
    /// `opposite` is the result of opposite_half_edges().
    QuadGraph(const Mesh& mesh, std::span<const std::int32_t> opposite,
              std::span<const QuadCell> cells);

    /// Halves the items (see Halve) by graph bisection. Up to 24 items, and halves that would break
    /// the bounds, are halved by halve_by_place() instead.
    std::size_t halve(std::span<QuadItem> items, const HalfBounds& bounds);

  private:
    void add_to_last_row(std::int32_t target, std::int32_t length);

    std::vector<std::int32_t> begin_, targets_, lengths_;
    std::vector<std::int32_t> local_;  ///< index of each cell among the items being halved, else -1
};

}  // namespace burl
