#pragma once
// Clustering of the quad atlas's cells: recursive coordinate bisection (RCB) of the cells' centres
// by weighted median, or bisection of the graph of neighbouring pairs, as in the paper (Carr & Hart
// 2001, section 4.3), by a multilevel partitioner (Karypis & Kumar). Everything is decided on
// integers, so that the mesh's unit of length does not matter and no two runs differ.
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "atlas/blocks/quad_cells.h"
#include "atlas/mesh/mesh.h"

namespace burl {

/// A cell with its place and weight as integers.
struct QuadItem {
    std::array<std::uint32_t, 3> key{};  ///< centre in 2^-24 of the centres' box's longest side
    std::uint32_t cell = 0;
    std::uint64_t weight = 0;  ///< texels wanted, in 2^-20 texels, borders included
};

/// Width in texels of the gutter round a block of width x height: the gutter asked for, halved
/// until it is an eighth of the shorter side at most. 0 for nearest lookups.
std::uint32_t quad_gutter(const AtlasOptions& options, std::uint32_t width, std::uint32_t height);

/// Items of the cells, in the cells' order.
std::vector<QuadItem> quad_items(std::span<const QuadCell> cells, const AtlasOptions& options);

/// Limits of the number of items in the first of two halves: 1 <= least <= most < items.
struct HalfBounds {
    std::size_t least = 1, most = 1;
};

/// A bisection method. run() reorders two or more items so that the first k (returned) are one
/// half, with about half the weight.
struct Halve {
    std::function<std::size_t(std::span<QuadItem> items, const HalfBounds& bounds)> run;
    bool apart = false;  ///< whether several threads may halve disjoint items at a time
};

/// Halves items by their coordinates: weighted median along the axis of widest spread, or, for up
/// to 24 items, along the axis with the most even cut. Returns the number of items in the first
/// half.
std::size_t halve_by_place(std::span<QuadItem> items, const HalfBounds& bounds);

/// The graph of cells and their neighbours in compressed sparse rows; the weight of an edge is the
/// length of the cells' common border, 64 for the mesh's mean edge. Clusters made by its bisection
/// have short borders and are mostly, though not always, connected on the surface.
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
