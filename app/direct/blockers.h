#pragma once
// What stands in the way of light: all placements of a mesh's triangles, by rays; and what else is
// seen through a surface.
#include <cstdint>
#include <optional>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/shape/ray_tree.h"

namespace burl {

/// A plane up to the horizon: the points p of the scene with normal . p = offset. The normal has
/// any length but 0.
struct Plane {
    Vec3d normal{0.0, 1.0, 0.0};
    double offset = 0.0;
};

/// The first surface that a ray meets.
struct Met {
    double distance = 0.0;
    std::uint32_t triangle = 0;        ///< of the mesh, where `placement` is not null
    const Mat4d* placement = nullptr;  ///< an element of Part::instances
    std::size_t plane = 0;             ///< of the planes, where `placement` is null
};

/// A mesh in scene coordinates, prepared for rays, and planes, which throw no shadow.
class Blockers {
  public:
    /// `mesh` must outlive this object. Throws Error(runtime) where memory for the rays' hierarchy
    /// runs out.
    explicit Blockers(const Mesh& mesh, std::vector<Plane> planes = {});

    /// Whether a ray meets a triangle, however far away. The direction has length 1.
    bool blocked(const Vec3d& from, const Vec3d& direction) const;
    /// The first triangle or plane that a ray meets. The direction has length 1.
    std::optional<Met> first(const Vec3d& from, const Vec3d& direction) const;
    /// The distance by which rays start off a surface, in scene units.
    double offset() const { return 4e-6 * scale_; }
    /// The least y of all points; none where there are no triangles.
    std::optional<double> lowest() const { return lowest_; }

  private:
    /// A triangle of the mesh in one of its placements.
    struct Placed {
        std::uint32_t triangle;
        const Mat4d* placement;
    };
    void place_all(const Mesh& mesh, std::vector<Vec3d>& points, std::vector<Triangle>& triangles);
    ShapeRay ray(const Vec3d& from, const Vec3d& direction) const;
    double distance(const Placed& placed, const Vec3d& from, const Vec3d& direction) const;

    const Mesh& mesh_;
    std::vector<Plane> planes_;
    std::vector<Placed> placed_;
    Vec3d centre_{0.0};
    double scale_ = 1.0;  ///< half the longest side of the box of all points
    std::optional<double> lowest_;
    std::optional<RayTree> tree_;
};

}  // namespace burl
