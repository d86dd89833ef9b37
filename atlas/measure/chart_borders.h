#pragma once
// The borders of charts in the texture, for telling a seam's error from the rest.
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "atlas/solid/mesh_edges.h"

namespace burl {

/// All edges of triangles across which the texture does not go on, boundary edges included.
class ChartBorders {
  public:
    ChartBorders(const Atlas& atlas, std::span<const MeshEdge> edges);

    /// Whether a point of the texture lies within one texel of a border.
    bool near(const Vec2d& place) const;

  private:
    struct Segment {
        Vec2d a{0.0}, b{0.0};
    };
    void add(const Vec2d& a, const Vec2d& b);
    std::uint32_t cell(double x, double y) const;

    double size_;                    ///< side of the texture in texels
    std::uint32_t cells_;            ///< grid cells a side
    std::vector<Segment> segments_;  ///< pieces of at most one cell
    std::vector<std::pair<std::uint32_t, std::uint32_t>> in_cell_;  ///< cell and segment, ascending
};

}  // namespace burl
