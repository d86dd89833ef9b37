#pragma once
// Picking: from a ray or a texel to the triangle, the point of the mesh and its texture
// coordinates. Rays are intersected by the watertight test of Woop, Benthin and Wald ("Watertight
// Ray/Triangle Intersection", 2013), so that none passes between two triangles that share an edge.
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/scene/box_tree.h"
#include "app/scene/scene.h"

namespace burl {

/// A picked point of a surface.
struct SurfaceHit {
    std::uint32_t surface = 0;    ///< index into Scene::surfaces
    std::uint32_t triangle = 0;   ///< index into Surface::triangles
    std::uint32_t placement = 0;  ///< index into Surface::placements
    Vec3d weights{0.0};           ///< barycentric coordinates, by the triangle's corners; sum 1
    Vec3d point{0.0};             ///< the scene coordinates
    /// The picked point of the surface at rest, in its first placement. For a scene of
    /// baked_scene() (app/gl/draw/view_scene.h) these are the mesh's coordinates, which decide the
    /// colour: texture_from_mesh(recipe, mesh) maps them to texture coordinates.
    Vec3d mesh_point{0.0};
    /// The texture coordinates; texel (i,j) of N x N has its centre at (i+0.5, j+0.5)/N.
    Vec2d uv{0.0};
    double depth = 0.0;  ///< the ray's t, for hits of meet()
};

/// The BVHs of a scene, which it keeps alive. May be used by several threads at a time.
class SurfacePick {
  public:
    /// Builds the BVHs with morph targets at weight `share`: 1 to 2 microseconds and some 70 bytes
    /// per triangle. Triangles must index their surface's positions.
    explicit SurfacePick(std::shared_ptr<const Scene> scene, double share = 0.0);

    const Scene& scene() const { return *scene_; }
    double share() const { return share_; }
    /// The normal of the hit triangle in its placement, of any length.
    Vec3d normal(const SurfaceHit& hit) const;
    /// The first intersection along the ray with either side of a triangle, in any placement; the
    /// first in order among equally near ones. Triangles without area are ignored.
    std::optional<SurfaceHit> meet(const Ray& ray) const;
    /// The triangle, in its surface's first placement, that shows these texture coordinates. In
    /// gutters, the nearest triangle no farther away than `reach` (in uv units), and its nearest
    /// point. No value where there is none.
    std::optional<SurfaceHit> at(const Vec2d& uv, double reach = 0.0) const;

  private:
    /// The local positions of the surface's vertices, morph target included.
    const std::vector<Vec3d>& places(std::uint32_t surface) const {
        const std::vector<Vec3d>& moved = trees_[surface].moved;
        return moved.empty() ? scene_->surfaces[surface].positions : moved;
    }
    SurfaceHit completed(SurfaceHit hit) const;

    /// The BVHs of a surface.
    struct Trees {
        /// Positions with the morph target; empty where they are those at rest.
        std::vector<Vec3d> moved;
        BoxTree points, uvs;
        std::vector<Mat4d> local_from_scene;  ///< one per placement
    };

    std::shared_ptr<const Scene> scene_;
    double share_;
    std::vector<Trees> trees_;  ///< one per surface
};

}  // namespace burl
