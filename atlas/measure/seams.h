#pragma once
// Seams as a viewer sees them: what lies near a chart's border, and the difference between lookups
// of a point of an edge from its two sides (Purnomo, Cohen, Kumar, "Seamless Texture Atlases",
// 2004: zero in a seamless atlas).
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "atlas/base/image.h"
#include "atlas/measure/charts.h"

namespace burl {

/// The borders of charts in the texture, for telling a seam's error from the rest: all edges of
/// triangles across which the texture does not go on, boundary edges included. They are cut into
/// segments no longer than a cell of a uniform grid; every cell lists those that come within a
/// texel of it.
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
    std::vector<Segment> segments_;  ///< parts of at most one cell
    std::vector<std::pair<std::uint32_t, std::uint32_t>> in_cell_;  ///< cell and segment, ascending
};

/// Places on both sides of points that are spread evenly by length over the seams: the interior
/// edges whose sides have different places.
struct SeamPoints {
    std::vector<std::array<Vec2d, 2>> places;  ///< places of the points in texels of level 0
    double share = 0.0;                        ///< length of the seams over all interior edges
};

/// `count` points on the seams, one at random in each of `count` equal shares of their length;
/// empty without seams.
SeamPoints seam_points(const Mesh& mesh, const Atlas& atlas, std::span<const MeshEdge> edges,
                       std::size_t count, std::uint64_t seed);

/// RMS difference of bilinear lookups in `level` from the two sides, over all interior edges by
/// length: sqrt(share) times that over `points`. `size` is the side of level 0 in texels.
double mismatch(const SeamPoints& points, const Image<Vec3f>& level, std::uint32_t size);

}  // namespace burl
