#pragma once
// A mesh as its masks see it: faces with their normals, moved to the origin and scaled to a
// diagonal of 1, so that every distance is relative to the mesh.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "atlas/mesh/mesh.h"
#include "atlas/shape/ray_tree.h"

namespace burl {

/// Distance, as a share of the bounding box's diagonal, by which rays start off the surface: 16
/// times what float32 rounds a coordinate by, at most.
inline constexpr double ray_offset = 1e-6;

/// Points that a thread works on at a time.
inline constexpr std::size_t points_at_a_time = 64;

/// A point of a mesh's surface at which a mask is asked for.
struct ShapePoint {
    Vec3d position{0.0};         ///< in mesh units
    Vec3d normal{0.0};           ///< the triangle's unit normal; zero for one without area
    Vec3d shading{0.0};          ///< unit normal that shading uses; on the side of `normal`
    std::uint32_t triangle = 0;  ///< the triangle it lies on
};

/// Weights of a triangle's corners (sum 1, none negative) for those of a point that may lie outside
/// it: negative ones become 0; a third each where none is left.
Vec3d onto_triangle(const Vec3d& weights);

/// A mesh prepared for masks. It keeps copies of what it needs of the mesh.
class ShapeScene {
  public:
    explicit ShapeScene(const Mesh& mesh);

    /// A copy of the shape with other shading normals: one for each corner (3t+k) of its triangles,
    /// or none.
    ShapeScene with_normals(std::vector<Vec3f> corner_normals) const;

    /// The surface's point at these weights of the triangle's corners (sum 1). Points outside the
    /// triangle, as gutters show them, are moved onto it: negative weights become 0. No point comes
    /// nearer to an edge than 4 ray offsets, so that one on a concave edge stays outside the solid;
    /// triangles less than 24 offsets high keep a sixth of their height.
    ShapePoint surface_point(std::uint32_t triangle, const Vec3d& weights) const;
    /// Weights of the corners at the point of the triangle's plane below `position` (mesh units);
    /// a third each where the triangle has no area.
    Vec3d weights_at(std::uint32_t triangle, const Vec3d& position) const;

    /// The gradients of these weights with respect to `position`, along the triangle and per mesh
    /// unit; 0 where the triangle has no area.
    std::array<Vec3d, 3> weight_slopes(std::uint32_t triangle) const;

    /// Maps a point in mesh units to the unit space.
    Vec3d to_unit(const Vec3d& position) const { return (position - centre_) / diagonal_; }
    double diagonal() const { return diagonal_; }  ///< of the bounding box, in mesh units; > 0

    std::span<const Vec3d> points() const { return points_; }  ///< the mesh's, in the unit space
    std::span<const Triangle> triangles() const { return triangles_; }
    std::span<const Vec3d> normals() const { return normals_; }  ///< of the triangles, as above
    std::span<const double> areas() const { return areas_; }  ///< of the triangles, in unit space
    /// Shading normals of the triangles' corners, 3t+k; none where there are no others than the
    /// triangles' own.
    std::span<const Vec3f> corner_normals() const { return corner_normals_; }
    const RayTree& rays() const { return rays_; }

  private:
    Vec3d inset(std::uint32_t triangle, const Vec3d& weights) const;
    Vec3d shading_normal(std::uint32_t triangle, const Vec3d& weights) const;

    Vec3d centre_;
    double diagonal_;
    std::vector<Vec3d> points_;
    std::vector<Triangle> triangles_;
    std::vector<Vec3d> normals_;
    std::vector<double> areas_;
    std::vector<Vec3f> corner_normals_;  ///< the mesh's, empty where it has none
    RayTree rays_;
};

}  // namespace burl
