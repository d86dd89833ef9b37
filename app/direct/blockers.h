#pragma once
// What stands in the way of light: all placements of a mesh's triangles, by rays.
#include <optional>

#include "atlas/mesh/mesh.h"
#include "atlas/shape/ray_tree.h"

namespace burl {

/// A mesh in scene coordinates, prepared for rays.
class Blockers {
  public:
    /// Throws Error(runtime) where memory for the rays' hierarchy runs out.
    explicit Blockers(const Mesh& mesh);

    /// Whether a ray meets a triangle, however far away. The direction has length 1.
    bool blocked(const Vec3d& from, const Vec3d& direction) const;
    /// The distance by which rays start off a surface, in scene units.
    double offset() const { return 4e-6 * scale_; }
    /// The least y of all points; none where there are no triangles.
    std::optional<double> lowest() const { return lowest_; }

  private:
    Vec3d centre_{0.0};
    double scale_ = 1.0;  ///< half the longest side of the box of all points
    std::optional<double> lowest_;
    std::optional<RayTree> tree_;
};

}  // namespace burl
