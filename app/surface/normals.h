#pragma once
// Shading normals for meshes that bring none: angle-weighted (Thuermer & Wuethrich, "Computing
// Vertex Normals from Polygonal Facets", 1998), split at creases.
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"

namespace burl {

/// The vector at unit length, or zero where it is zero or not finite. It is scaled first, since
/// squares of tiny numbers underflow.
Vec3d unit_or_zero(const Vec3d& v);

/// The angle between two unit vectors, in radians; 0 where one is zero.
double angle_between(const Vec3d& u, const Vec3d& v);

/// The angle of a triangle at its corner k, in radians; 0 where it has no area.
double corner_angle(std::span<const Vec3d> positions, const Triangle& triangle, std::size_t k);

/// The triangle corners 3t+k that meet at each point of a mesh, ascending, in compressed rows
/// (CSR).
class CornersByPoint {
  public:
    explicit CornersByPoint(const Mesh& mesh);

    std::size_t points() const { return begin_.size() - 1; }
    std::span<const std::uint32_t> operator[](std::size_t point) const {
        return {corners_.data() + begin_[point], begin_[point + 1] - begin_[point]};
    }

  private:
    /// The corners of point p are corners_[begin_[p]] to corners_[begin_[p + 1] - 1].
    std::vector<std::uint32_t> begin_, corners_;
};

/// One unit normal per triangle corner (3t+k): the mesh's own where it has them. Zero or non-finite
/// ones, and all normals of a mesh without any, are computed: around each point, faces connected
/// across edges whose dihedral angle is below `crease_degrees` share one normal, the mean of their
/// face normals weighted by the angle each face has at the point. So shading is continuous across
/// every edge that is not a crease. Degenerate faces have no weight, do not interrupt the smoothing
/// of the faces beside them and take a neighbour's normal, or +Z where there is none.
std::vector<Vec3f> corner_normals(const Mesh& mesh, double crease_degrees);

}  // namespace burl
