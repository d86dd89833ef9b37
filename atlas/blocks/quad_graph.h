#pragma once
// Clusters of the quad atlas by the paper's own means: the graph of neighbouring pairs is bisected
// by a multilevel partitioner (Karypis & Kumar; Carr & Hart 2001, section 4.3), so that clusters
// have short borders and are mostly, though not always, connected on the surface.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/blocks/quad_order.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// Cells and their neighbours as compressed rows; an edge weighs the length the two have in common,
/// 64 for the mean edge of the mesh.
class QuadGraph {
  public:
    /// `opposite` as of opposite_half_edges.
    QuadGraph(const Mesh& mesh, std::span<const std::int32_t> opposite,
              std::span<const QuadCell> cells);

    /// As a Halve. A few items, and halves that would break the bounds, go by their place instead.
    std::size_t halve(std::span<QuadItem> items, const HalfBounds& bounds);

  private:
    void add_to_last_row(std::int32_t target, std::int32_t length);

    std::vector<std::int32_t> begin_, targets_, lengths_;
    std::vector<std::int32_t> local_;  ///< per cell its number among the items at work, else -1
};

}  // namespace burl
