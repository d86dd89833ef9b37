#pragma once
// What of a scene lies under a pointer: from a ray or a texel to the triangle, the point of the
// mesh and the place in the texture. Rays meet triangles by the watertight test of Woop, Benthin
// and Wald ("Watertight Ray/Triangle Intersection", 2013), so that none slips through between two
// triangles that share an edge.
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/scene/box_tree.h"
#include "app/scene/scene.h"

namespace burl {

/// A place on a surface.
struct SurfaceHit {
    std::uint32_t surface = 0;    ///< index into Scene::surfaces
    std::uint32_t triangle = 0;   ///< index into Surface::triangles
    std::uint32_t placement = 0;  ///< index into Surface::placements
    Vec3d weights{0.0};           ///< barycentric, of the triangle's corners in order; sum 1
    Vec3d point{0.0};             ///< in the scene
    /// The same point of the surface, before it went to its target, where its first placement has
    /// it. For a scene of
    /// baked_scene() (app/gl/draw/view_scene.h) these are the mesh's coordinates, which decide the
    /// colour: texture_from_mesh(recipe, mesh) takes them.
    Vec3d mesh_point{0.0};
    Vec2d uv{0.0};  ///< of the texture; texel (i,j) of N x N has its centre at (i+0.5, j+0.5)/N
    double depth = 0.0;  ///< of meet(): along the ray
};

/// Built once for a scene, which it keeps. May be used by several threads at a time.
class SurfacePick {
  public:
    /// Triangles' corners must lie within their surface's positions. 1 to 2 microseconds a
    /// triangle, some 70 bytes of each.
    /// Surfaces that have a target have gone `share` of the way there.
    explicit SurfacePick(std::shared_ptr<const Scene> scene, double share = 0.0);

    const Scene& scene() const { return *scene_; }
    double share() const { return share_; }
    /// Of the triangle in its placement, of any length.
    Vec3d normal(const SurfaceHit& hit) const;
    /// The first triangle that the ray meets, from either side, in any placement; of equally near
    /// ones the first in order. Triangles without area are not met.
    std::optional<SurfaceHit> meet(const Ray& ray) const;
    /// The triangle that shows this place of the texture, in its first placement. Where none does
    /// (gutters): the nearest no farther away than `reach`, in units of uv, and the place of it
    /// that is nearest.
    std::optional<SurfaceHit> at(const Vec2d& uv, double reach = 0.0) const;

  private:
    /// Where the surface's vertices are, local.
    const std::vector<Vec3d>& places(std::uint32_t surface) const {
        const std::vector<Vec3d>& moved = trees_[surface].moved;
        return moved.empty() ? scene_->surfaces[surface].positions : moved;
    }
    SurfaceHit completed(SurfaceHit hit) const;

    struct Trees {
        std::vector<Vec3d> moved;  ///< on their way to a target; empty: they are where they are
        BoxTree points, uvs;
        std::vector<Mat4d> local_from_scene;  ///< per placement
    };

    std::shared_ptr<const Scene> scene_;
    double share_;
    std::vector<Trees> trees_;  ///< per surface
};

}  // namespace burl
